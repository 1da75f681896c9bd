#include "output/run/run_writer.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "base/printable.hpp"
#include "output/folder/files.hpp"
#include "output/folder/summary.hpp"
#include "output/folder/tables.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/report/report.hpp"

namespace reye::output {

namespace fs = std::filesystem;

RunWriter::RunWriter(std::string dir, const scene::Scene& scene)
    : dir_(std::move(dir)), identity_(identity_of(scene)), paraview_(scene.output.frames.paraview) {
  for (const auto& contact : scene.contacts) columns_.contacts.push_back(contact.name);
  for (const auto& support : scene.supports)
    columns_.supports.push_back({support.name, support.rigid && scene.analysis != base::Analysis::axisymmetric});
  for (const auto& bond : scene.bonds) columns_.bonds.push_back(bond.name);
}

std::string RunWriter::path(const std::string& file) const { return (fs::path(dir_) / file).string(); }

void RunWriter::begin() {
  fs::create_directories(dir_);
  claim_folder(dir_, identity_);
  make_folder(path("frames"));
  counters_ = {};
  atomic_write(path("history.csv"), history_header(columns_, identity_.analysis));
  started_ = true;
  flush_log();
}

void RunWriter::resume(const Counters& counters) {
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

void RunWriter::increment(const sim::IncrementRecord& record) {
  assert(started_);
  append_text(path("history.csv"), history_row(record));
  ++counters_.history_rows;
}

void RunWriter::remesh(const sim::RemeshRecord& record) {
  assert(started_);
  if (counters_.remesh_rows++ == 0) atomic_write(path("remesh.csv"), remesh_header(identity_.analysis));
  append_text(path("remesh.csv"), remesh_row(record));
}

void RunWriter::frame(const sim::Frame& frame) {
  assert(started_);
  const std::size_t index = counters_.frame_cycles.size();
  counters_.frame_cycles.push_back(frame.cycle);
  for (const auto* surfaces : {&frame.surfaces, &frame.bonds})
    for (const auto& surface : *surfaces) {
      const std::string file = surface_file(surface.contact, surface.side);
      long& rows = counters_.surface_rows[file];
      if (rows == 0) atomic_write(path(file), surface_header());
      append_text(path(file), surface_rows(index, frame, surface));
      rows += static_cast<long>(surface.arc_length_mm.size());
    }
  if (!paraview_) return;
  atomic_write(path(frame_file("bodies", "vtu", index)), bodies_vtu(frame));
  atomic_write(path(frame_file("surface", "vtp", index)), surfaces_vtp(frame));
  write_collections();
}

void RunWriter::write_collections() const {
  const auto times = frame_times(counters_.frame_cycles);
  atomic_write(path("series.pvd"), collection("bodies", "vtu", times));
  atomic_write(path("surfaces.pvd"), collection("surface", "vtp", times));
}

void RunWriter::remove_frames_from(std::size_t index) const {
  std::error_code none;
  while (fs::remove(path(frame_file("bodies", "vtu", index)), none) |
         fs::remove(path(frame_file("surface", "vtp", index)), none))
    ++index;
}

void RunWriter::extend() const { mark_folder(dir_, identity_); }

void RunWriter::finish(const sim::Summary& summary) {
  atomic_write(path("summary.json"), summary_json(summary));
  write_report(dir_);
}

void RunWriter::log(const std::string& line) {
  early_log_ += base::printable(line) + '\n';
  if (started_) flush_log();
}

void RunWriter::flush_log() {
  std::error_code none;
  const auto size = fs::file_size(path("log.txt"), none);
  const bool full = !none && size >= most_log_bytes;
  if (!none && !full && size + early_log_.size() >= most_log_bytes) early_log_ += "the log is full and ends here\n";
  if (!full && !early_log_.empty()) append_text(path("log.txt"), early_log_);
  early_log_.clear();
}

}  // namespace reye::output
