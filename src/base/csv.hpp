#pragma once
#include <string>
#include <vector>

namespace reye::base {

/// Columns of numbers under a line of names, as read from a CSV file.
struct NumberTable {
  struct Row {
    int line = 0;  ///< of the file, from 1
    std::vector<double> values;
  };

  std::vector<std::string> names;
  std::vector<Row> rows;

  /// The column of a name; -1: there is none.
  int column(const std::string& name) const;
};

/// The table in the text of a CSV file: commas between columns, decimal points, blank lines left out, whatever the
/// locale. Throws InputError with one issue, whose rule names the line: the first line is not `header` (where one is
/// asked for), a row that is not as many finite numbers as there are names.
NumberTable parse_numbers(const std::string& csv, const std::string& header = {});

}  // namespace reye::base
