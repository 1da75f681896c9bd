#include "output/report/html.hpp"

#include "output/folder/text.hpp"

namespace reye::output {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
body { margin: 0 auto; max-width: 1180px; padding: 28px 24px 60px; color: #2b2f36; background: #fff;
       font: 15px/1.5 Helvetica, Arial, "DejaVu Sans", sans-serif; }
h1 { font-size: 26px; line-height: 1.25; margin: 0 0 6px; }
h2 { font-size: 18px; margin: 34px 0 10px; padding-bottom: 5px; border-bottom: 1px solid #d9dde2; }
p { margin: 4px 0; }
.quiet { color: #6a717c; font-size: 13px; word-break: break-all; }
.status { display: inline-block; padding: 2px 12px; border-radius: 11px; color: #fff; font-weight: 600; }
.done { background: #2f8f5b; } .failed { background: #b8352a; } .interrupted, .open { background: #b08900; }
table { border-collapse: collapse; margin: 6px 0 10px; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 4px 18px 4px 0; border-bottom: 1px solid #eceff2; vertical-align: top; }
th { font-weight: 600; } tbody th { font-weight: 400; } thead th { color: #6a717c; font-size: 13px; }
td.number { text-align: right; white-space: nowrap; } th.number { text-align: right; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(480px, 1fr)); gap: 18px; }
figure { margin: 0; break-inside: avoid; } figure svg { width: 100%; height: auto; display: block; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 0 40px; }
li { margin: 2px 0; }
.warnings { margin: 14px 0; padding: 2px 18px 8px; background: #fff6df; border-left: 4px solid #b08900; }
pre { white-space: pre-wrap; font: 12px/1.45 "DejaVu Sans Mono", monospace; color: #4a5058; }
.warnings h2 { border: 0; margin: 8px 0 4px; }
@media print { body { max-width: none; padding: 0; font-size: 12px; } h2 { break-after: avoid; }
  .figures { grid-template-columns: 1fr 1fr; } }
)";

}  // namespace

std::string html_page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
         "<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         escaped(title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

std::string html_table(const Row& head, const std::vector<Row>& rows, const std::set<std::size_t>& texts,
                       const std::vector<std::string>& links) {
  if (rows.empty()) return {};
  const auto open = [&](const std::string& cell, std::size_t i) {
    return '<' + cell + (i == 0 || texts.count(i) ? ">" : " class=\"number\">");
  };
  std::string html = "<table>\n<thead><tr>";
  for (std::size_t i = 0; i < head.size(); ++i) html += open("th", i) + escaped(head[i]) + "</th>";
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Row& row = rows[r];
    const std::string label = escaped(row[0]);
    html += "<tr><th>" + (links.empty() ? label : "<a href=\"" + escaped(links[r]) + "\">" + label + "</a>") + "</th>";
    for (std::size_t i = 1; i < row.size(); ++i) html += open("td", i) + escaped(row[i]) + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

std::string figure_grid(const std::string& heading, const std::vector<Figure>& all) {
  if (all.empty()) return {};
  std::string html = "<h2>" + escaped(heading) + "</h2>\n<div class=\"figures\">\n";
  for (const auto& figure : all) html += "<figure id=\"" + escaped(figure.id) + "\">\n" + svg(figure) + "</figure>\n";
  return html + "</div>\n";
}

}  // namespace reye::output
