#include "output/report/page_parts.hpp"

#include <vector>

#include "output/folder/files.hpp"
#include "output/folder/text.hpp"

namespace reye::output {

namespace fs = std::filesystem;

std::string page_heading(const RunData& run, const std::string& kind) {
  const bool ended = run.summary.is_object();
  const std::string status = ended ? run.summary.value("status", "open") : "open";
  std::string html = "<h1>" + escaped(run.identity.title) + "</h1>\n<p><span class=\"status " + escaped(status) +
                     "\">" + (ended ? escaped(status) : "not finished") + "</span></p>\n";
  if (ended && run.summary.contains("reason") && run.summary["reason"].is_string())
    html += "<p><strong>Reason:</strong> " + escaped(run.summary["reason"].get<std::string>()) + "</p>\n";
  if (!ended) html += "<p>The run has not ended, or was killed: the figures show what is on disk so far.</p>\n";
  for (const auto& [contact, sides] : run.identity.sides)
    html += "<p>Contact " + escaped(contact) + ": secondary side " + escaped(sides[0]) + ", primary side " +
            escaped(sides[1]) + ".</p>\n";
  return html + "<p class=\"quiet\">Scene " + escaped(run.identity.name) + " · " + kind + " · reye " + version +
         "</p>\n";
}

std::string warning_list(const RunData& run) {
  if (!run.summary.is_object()) return {};
  const auto warnings = run.summary.find("warnings");
  if (warnings == run.summary.end() || !warnings->is_array() || warnings->empty()) return {};
  std::string html = "<div class=\"warnings\">\n<h2>Warnings</h2>\n<ul>\n";
  for (const auto& w : *warnings) {
    const std::string about = w.contains("about") && w["about"].is_string() ? ", " + w["about"].get<std::string>() : "";
    html += "<li><strong>" + escaped(w.value("kind", "") + about) + ":</strong> " + escaped(w.value("text", "")) +
            "</li>\n";
  }
  return html + "</ul>\n</div>\n";
}

std::string scene_section(const std::string& dir) {
  const auto file = fs::path(dir) / "scene.svg";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  const std::string picture = read_text(file.string());
  return picture.starts_with("<svg") ? "<h2>Scene</h2>\n<figure id=\"scene\">\n" + picture + "</figure>\n" : "";
}

std::string scene_file(const RunData& run) {
  if (run.identity.scene_text.empty()) return {};
  return "<details class=\"scene\"><summary>The scene file: materials, contacts, loads and steps</summary>\n<pre>" +
         escaped(run.identity.scene_text) + "</pre></details>\n";
}

std::filesystem::path emptied_figures(const std::string& dir) {
  const auto folder = fs::path(dir) / "figures";
  make_folder(folder.string());
  std::vector<fs::path> former;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".svg") former.push_back(entry.path());
  for (const auto& path : former) fs::remove(path);
  return folder;
}

}  // namespace reye::output
