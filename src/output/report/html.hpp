#pragma once
#include <set>
#include <string>
#include <vector>

#include "output/report/plot.hpp"

/// Pieces of a page; texts are escaped here.
namespace reye::output {

/// One file without outside resources, for screen and print.
std::string html_page(const std::string& title, const std::string& body);

/// Cells of a row, a label first.
using Row = std::vector<std::string>;

/// All columns but the first and those in `texts` are set as numbers. `links`: per row where its label leads, else
/// empty. Nothing without rows.
std::string html_table(const Row& head, const std::vector<Row>& rows, const std::set<std::size_t>& texts = {},
                       const std::vector<std::string>& links = {});

/// Figures side by side under a heading; nothing without any.
std::string figure_grid(const std::string& heading, const std::vector<Figure>& all);

}  // namespace reye::output
