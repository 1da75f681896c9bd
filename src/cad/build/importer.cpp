#include "cad/build/importer.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>

#include "base/formatted.hpp"
#include "cad/meshing/kernel.hpp"
#include "cad/meshing/mesher.hpp"
#include "cad/part/importer_process.hpp"
#include "cad/part/raw_bytes.hpp"

namespace reye::cad {

namespace {

std::string exactly(double x) { return base::formatted("%a", x); }

/// What import/main.cpp receives: whether to trust, the folder, the section's point and normal or "-", the files.
std::vector<std::string> words_for(const GeometryOptions& options, std::size_t first) {
  std::vector<std::string> words = {options.trusted ? "trusted" : "guarded", options.folder};
  std::string section = "-";
  if (options.section) {
    section.clear();
    for (const Vec3& v : {options.section->point_mm, options.section->normal})
      for (double x : v) section += exactly(x) + ' ';
  }
  words.push_back(section);
  words.insert(words.end(), options.files.begin() + static_cast<std::ptrdiff_t>(first), options.files.end());
  return words;
}

Answer answer_about(const std::string& file, const std::string& bytes) {
  try {
    Answer answer = answer_of(bytes);
    if (answer.parts.empty() && answer.issues.empty()) throw std::runtime_error("is no face");
    return answer;
  } catch (const std::runtime_error& error) {
    return {{}, {{"geometry", "\"" + file + "\"", std::string("what is read of it ") + error.what()}}};
  }
}

void take(Answer answer, const std::string& file, Imported& all, std::vector<base::Issue>& issues) {
  for (RawPart& part : answer.parts) {
    part.file = file;
    all.parts.push_back(std::move(part));
  }
  issues.insert(issues.end(), std::make_move_iterator(answer.issues.begin()),
                std::make_move_iterator(answer.issues.end()));
}

}  // namespace

Imported import_files(const GeometryOptions& options) {
  const double most_s = options.trusted ? std::numeric_limits<double>::infinity() : waiting_s;
  Imported all;
  std::vector<base::Issue> issues;
  for (std::size_t k = 0; k < options.files.size();) {
    const auto first = options.files.begin() + static_cast<std::ptrdiff_t>(k);
    auto importer = std::make_unique<ImporterProcess>(words_for(options, k));
    const auto guarded = importer->message(most_s);
    if (!guarded) {  // it has not seen a file yet
      kernel();      // says why, where it is gmsh that cannot be loaded
      throw std::runtime_error("reye-import does not start: " + importer->end_in_words());
    }
    all.guarded = all.guarded && *guarded == "guarded";
    for (; k < options.files.size(); ++k) {
      const auto bytes = importer->message(most_s);
      if (!bytes) break;
      take(answer_about(options.files[k], *bytes), options.files[k], all, issues);
    }
    if (k == options.files.size()) {
      if (std::any_of(first, options.files.end(), needs_gmsh)) mesh_in(std::move(importer), options.trusted);
      break;
    }
    issues.push_back({"geometry", "\"" + options.files[k] + "\"", importer->end_in_words()});
    ++k;  // the next one may be sound
  }
  if (options.files.empty()) issues.push_back({"geometry", "[]", "names no file"});
  if (!issues.empty()) throw base::InputError(std::move(issues));
  return all;
}

}  // namespace reye::cad
