#include "output/report/report.hpp"

#include <filesystem>

#include "base/errors.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"
#include "output/report/animation.hpp"
#include "output/report/figures.hpp"
#include "output/report/html.hpp"
#include "output/report/page_parts.hpp"
#include "output/report/report_tables.hpp"
#include "output/report/run_data.hpp"
#include "output/report/shape_figures.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

std::string heading(const RunData& run) {
  const char* kind[] = {"plane strain, per mm of thickness", "plane stress, per mm of thickness",
                        "axisymmetric, whole circumference"};
  return page_heading(run, kind[static_cast<int>(run.identity.analysis)]);
}

/// Moving figures, in step with each other; where scripts run, with a slider to hold them at any frame.
std::string film(const std::vector<Figure>& moving) {
  if (moving.empty()) return {};
  const std::string seconds = number(moment_seconds), last = std::to_string(moving.front().moments.size() - 1);
  std::string html =
      "<h2>Animation</h2>\n<p id=\"hand\" hidden=\"hidden\"><button type=\"button\" onclick=\"play()\">play</button> "
      "<input type=\"range\" id=\"moment\" min=\"0\" max=\"" +
      last + "\" value=\"" + last + "\" oninput=\"hold(Number(this.value))\"/></p>\n<div class=\"figures moving\">\n";
  for (const auto& figure : moving)
    html += "<figure id=\"" + escaped(figure.id) + "\">\n" + svg(figure) + "</figure>\n";
  return html +
         "</div>\n<script>\ndocument.getElementById('hand').hidden = false;\nconst films = "
         "document.querySelectorAll('.moving svg');\n"
         "function hold(k) { films.forEach(f => { f.pauseAnimations(); f.setCurrentTime((k + 0.5) * " +
         seconds +
         "); }); }\nfunction play() { films.forEach(f => { f.setCurrentTime(0); f.unpauseAnimations(); }); "
         "}\n</script>\n";
}

std::string page(const std::string& dir, const RunData& run, const std::vector<Figure>& all,
                 const std::vector<Figure>& moving) {
  std::string html;
  html += heading(run) + warning_list(run) + scene_section(dir) + result_tables(run) + film(moving) +
          figure_grid("Figures", all) + ledger_table(run) + remesh_table(run) + run_tables(run) + scene_file(run);
  html += "<p class=\"quiet\">Scene and geometry sha256 " + escaped(run.identity.sha256) + "</p>\n";
  return html_page(run.identity.title, html);
}

/// Worn profile and pressure of each contact beside each other: the most important picture of a run.
void write_overviews(const RunData& run, const std::vector<Figure>& all, const fs::path& folder) {
  for (const auto& contact : run.contacts) {
    const std::string name = file_part(contact.name);
    std::vector<Figure> row;
    for (const auto& figure : all)
      if (figure.id == "profile-" + name + "-secondary" || figure.id == "pressure-" + name) row.push_back(figure);
    if (row.size() == 2) replace_text((folder / ("overview-" + name + ".svg")).string(), svg_row(row));
  }
}

/// The page; a summary with another type where a text is expected counts as damaged.
std::string page_of(const std::string& dir, const RunData& run, const std::vector<Figure>& all,
                    const std::vector<Figure>& moving) {
  try {
    return page(dir, run, all, moving);
  } catch (const nlohmann::json::exception& error) {
    throw base::InputError({{"dir", "", (fs::path(dir) / "summary.json").string() + " is damaged: " + error.what()}});
  }
}

std::vector<Figure> all_figures(const RunData& run, const std::string& dir) {
  auto all = shape_figures(run, dir);
  for (auto& figure : figures(run)) all.push_back(std::move(figure));
  return all;
}

}  // namespace

void write_report(const std::string& dir, bool animation) {
  const RunData run = read_run(dir);
  const auto all = all_figures(run, dir);
  const auto moving = animation ? moving_figures(run, dir) : std::vector<Figure>{};
  const std::string html = page_of(dir, run, all, moving);
  const auto folder = emptied_figures(dir);
  for (const auto* list : {&all, &moving})
    for (const auto& figure : *list) replace_text((folder / (figure.id + ".svg")).string(), svg(figure));
  write_overviews(run, all, folder);
  replace_text((fs::path(dir) / "report.html").string(), html);
}

}  // namespace reye::output
