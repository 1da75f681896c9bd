#include "export.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "base/printable.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"

namespace reye::apps {

namespace fs = std::filesystem;

namespace {

/// The run's name for its files: that of its folder, without ".out".
std::string stem_of(const std::string& dir) {
  auto path = fs::absolute(dir).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return output::file_part(path.extension() == ".out" ? path.stem().string() : path.filename().string());
}

/// "cycle_18000", or "frame_12" where a frame was asked for.
std::string moment_of(const ExportRequest& request, const output::ExportedShape& shape) {
  if (request.frame) return "frame_" + std::to_string(shape.frame);
  const bool whole = shape.cycle == std::floor(shape.cycle) && shape.cycle < 1e15;
  return "cycle_" + (whole ? base::formatted("%.0f", shape.cycle) : output::number(shape.cycle));
}

/// The file of each text.
std::vector<std::string> files_of(const ExportRequest& request, const output::ExportedShape& shape) {
  if (!request.out.empty()) return {request.out};
  std::vector<std::string> files;
  for (const auto& [body, text] : shape.texts)
    files.push_back("./" + stem_of(request.dir) + '_' + moment_of(request, shape) +
                    (body.empty() ? "" : '_' + output::file_part(body)) + '.' + request.format);
  return files;
}

void check_file(const std::string& file, bool force, std::vector<base::Issue>& issues) {
  std::error_code error;
  const auto parent = fs::absolute(file).parent_path();
  if (!fs::is_directory(parent, error) || ::access(parent.c_str(), W_OK | X_OK) != 0)
    issues.push_back({"--out", file, "it cannot be written in " + parent.string()});
  else if (fs::is_directory(file, error))
    issues.push_back({"--out", file, "it is a folder"});
  else if (fs::exists(fs::symlink_status(file, error)) && !force && !output::is_export(file))
    issues.push_back(
        {"--out", file, "it exists and is no former export; choose another file, or replace it with --force"});
}

void check_files(const ExportRequest& request, const output::ExportedShape& shape,
                 const std::vector<std::string>& files) {
  std::vector<base::Issue> issues;
  if (files.size() < shape.texts.size())
    issues.push_back(
        {"--out", request.out,
         "stl holds one body, and there are " + std::to_string(shape.texts.size()) + ": choose one with --body"});
  for (std::size_t k = 0; k < files.size(); ++k) {
    check_file(files[k], request.force, issues);
    if (std::find(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(k), files[k]) !=
        files.begin() + static_cast<std::ptrdiff_t>(k))
      issues.push_back({"--out", files[k], "two bodies have this file; choose one with --body and name its file"});
  }
  if (!issues.empty()) throw base::InputError(std::move(issues));
}

}  // namespace

int export_shape(const ExportRequest& request) {
  if (request.list) {
    for (const auto& line : output::frames_in_words(request.dir)) std::printf("%s\n", line.c_str());
    return 0;
  }
  const auto shape = output::export_shape(request);
  const auto files = files_of(request, shape);
  check_files(request, shape, files);
  for (std::size_t k = 0; k < files.size(); ++k) output::atomic_write(files[k], shape.texts[k].second);
  std::printf("frame %zu, cycle %s: worn shape, stress-free (not deformed)\n", shape.frame,
              output::number(shape.cycle).c_str());
  for (const auto& line : shape.lines) std::printf("%s\n", line.c_str());
  for (const auto& file : files) std::printf("%s\n", base::printable(file).c_str());
  for (const auto& warning : shape.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  return 0;
}

}  // namespace reye::apps
