#include "output/solid/solid_report.hpp"

#include <filesystem>

#include "base/errors.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"
#include "output/report/html.hpp"
#include "output/report/page_parts.hpp"
#include "output/solid/contact_maps.hpp"
#include "output/solid/solid_history.hpp"
#include "output/solid/solid_report_tables.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

/// The maps of a contact with what a reader must know of them.
std::string maps_section(const SolidRunData& data, const std::string& contact, const std::vector<Figure>& maps) {
  const std::string heading = data.inputs.contacts.size() > 1 ? "Maps of contact " + contact : "Maps of the contact";
  if (maps.empty())
    return "<h2>" + escaped(heading) + "</h2>\n<p>" +
           (data.inputs.paraview ? "No frame shows this contact under pressure."
                                 : "The scene asks for no frames for ParaView, from which maps are drawn.") +
           "</p>\n";
  return figure_grid(heading, maps) +
         "<p class=\"quiet\">The secondary side, unless the other is named, on its stress-free shape, seen along its "
         "mean normal; the thin line is "
         "the edge of the contact, half way between nodes. Arrows: the shear that acts on this side, and the path that "
         "this side slipped. "
         "Areas "
         "are those of the nodes.</p>\n";
}

std::string solid_page(const SolidRunData& data, const std::vector<std::vector<Figure>>& maps,
                       const std::vector<Figure>& histories) {
  const RunData& run = data.run;
  std::string html = page_heading(run, "solids in three dimensions") + warning_list(run) + scene_section(data.dir) +
                     solid_result_tables(data);
  for (std::size_t c = 0; c < maps.size(); ++c) html += maps_section(data, data.inputs.contacts[c], maps[c]);
  html += figure_grid("The run over its steps", histories) + solid_input_tables(data) + solid_remesh_table(data) +
          solid_run_tables(data) + scene_file(run) + "<p class=\"quiet\">Scene and geometry sha256 " +
          escaped(run.identity.sha256) + "</p>\n";
  return html_page(run.identity.title, html);
}

}  // namespace

void write_solid_report(const std::string& dir, bool animation) {
  const SolidRunData data = read_solid_run(dir);
  std::vector<std::vector<Figure>> maps;
  for (const auto& contact : data.inputs.contacts) {
    auto& all = maps.emplace_back(contact_maps(data, contact));
    for (auto& map : depth_maps(data, contact)) all.push_back(std::move(map));
    if (animation)
      for (auto& map : moving_maps(data, contact)) all.push_back(std::move(map));
  }
  const auto histories = solid_history_figures(data);
  std::string html;
  try {
    html = solid_page(data, maps, histories);
  } catch (const nlohmann::json::exception& error) {
    throw base::InputError({{"dir", "", (fs::path(dir) / "summary.json").string() + " is damaged: " + error.what()}});
  }
  const auto folder = emptied_figures(dir);
  maps.push_back(histories);
  for (const auto& list : maps)
    for (const auto& figure : list) replace_text((folder / (figure.id + ".svg")).string(), svg(figure));
  replace_text((fs::path(dir) / "report.html").string(), html);
}

}  // namespace reye::output
