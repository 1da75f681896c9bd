#include "output/run/run_files.hpp"

#include <cassert>
#include <chrono>
#include <filesystem>

#include "base/formatted.hpp"
#include "base/printable.hpp"
#include "output/folder/files.hpp"
#include "output/folder/tables.hpp"
#include "output/folder/vtk_frames.hpp"

namespace reye::output {

namespace fs = std::filesystem;

RunFiles::RunFiles(std::string dir, Identity identity, bool paraview)
    : dir_(std::move(dir)), identity_(std::move(identity)), paraview_(paraview && !dir_.empty()) {}

std::string RunFiles::path(const std::string& file) const { return (fs::path(dir_) / file).string(); }

void RunFiles::put(const std::string& file, const std::string& text) {
  if (in_memory())
    kept_[file] = text;
  else
    atomic_write(path(file), text);
}

void RunFiles::add(const std::string& file, const std::string& text) {
  if (in_memory())
    kept_[file] += text;
  else
    append_text(path(file), text);
}

void RunFiles::begin(const std::string& history_header) {
  if (!in_memory()) {
    fs::create_directories(dir_);
    claim_folder(dir_, identity_);
    make_folder(path("frames"));
  }
  counters_ = {};
  put("history.csv", history_header);
  started_ = true;
  flush_log();
}

void RunFiles::resume(const Counters& counters) {
  assert(!in_memory());
  counters_ = counters;
  remove_temporaries(dir_);
  keep_rows(path("history.csv"), counters_.history_rows);
  for (const auto& [file, rows] : counters_.surface_rows) keep_rows(path(file), rows);
  std::vector<fs::path> begun_later;
  for (const auto& entry : fs::directory_iterator(dir_)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("surface_", 0) == 0 && !counters_.surface_rows.count(name)) begun_later.push_back(entry.path());
  }
  if (counters_.remesh_rows > 0)
    keep_rows(path("remesh.csv"), counters_.remesh_rows);
  else
    begun_later.push_back(path("remesh.csv"));
  for (const auto& table : begun_later) fs::remove(table);
  // They belong to the run that is being resumed.
  for (const char* file : {"summary.json", "report.html"}) fs::remove(path(file));
  make_folder(path("frames"));
  remove_frames_from(counters_.frame_cycles.size());
  if (paraview_) write_collections();
  started_ = true;
  flush_log();
}

void RunFiles::add_history(const std::string& row) {
  assert(started_);
  add("history.csv", row);
  ++counters_.history_rows;
}

void RunFiles::add_remesh(const std::string& header, const std::string& row) {
  assert(started_);
  if (counters_.remesh_rows++ == 0) put("remesh.csv", header);
  add("remesh.csv", row);
}

std::size_t RunFiles::begin_frame(double cycle) {
  assert(started_);
  counters_.frame_cycles.push_back(cycle);
  return counters_.frame_cycles.size() - 1;
}

void RunFiles::add_surface(const std::string& file, const std::string& header, const std::string& rows,
                           std::size_t count) {
  long& held = counters_.surface_rows[file];
  if (held == 0) put(file, header);
  add(file, rows);
  held += static_cast<long>(count);
}

void RunFiles::write_frame(const std::string& bodies_vtu, const std::string& surfaces_vtp) const {
  const std::size_t index = counters_.frame_cycles.size() - 1;
  atomic_write(path(frame_file("bodies", "vtu", index)), bodies_vtu);
  atomic_write(path(frame_file("surface", "vtp", index)), surfaces_vtp);
  write_collections();
}

void RunFiles::write_collections() const {
  const auto times = frame_times(counters_.frame_cycles);
  atomic_write(path("series.pvd"), collection("bodies", "vtu", times));
  atomic_write(path("surfaces.pvd"), collection("surface", "vtp", times));
}

void RunFiles::remove_frames_from(std::size_t index) const {
  std::error_code none;
  while (fs::remove(path(frame_file("bodies", "vtu", index)), none) |
         fs::remove(path(frame_file("surface", "vtp", index)), none))
    ++index;
}

void RunFiles::extend() const { mark_folder(dir_, identity_); }

void RunFiles::log(const std::string& line) {
  if (in_memory()) return;
  early_log_ += base::printable(line) + '\n';
  if (started_) flush_log();
}

void RunFiles::make_report(const std::function<void()>& make) {
  if (in_memory()) return;
  const auto start = std::chrono::steady_clock::now();
  make();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  log(base::formatted("report made in %.4f s", passed.count()));
}

void RunFiles::flush_log() {
  std::error_code none;
  const auto size = fs::file_size(path("log.txt"), none);
  const bool full = !none && size >= most_log_bytes;
  if (!none && !full && size + early_log_.size() >= most_log_bytes) early_log_ += "the log is full and ends here\n";
  if (!full && !early_log_.empty()) append_text(path("log.txt"), early_log_);
  early_log_.clear();
}

}  // namespace reye::output
