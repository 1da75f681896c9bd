#include "output/run/run_writer.hpp"

#include "output/folder/files.hpp"
#include "output/folder/summary.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/report/report.hpp"

namespace reye::output {

RunWriter::RunWriter(std::string dir, const scene::Scene& scene)
    : folder_(std::move(dir), identity_of(scene), scene.output.frames.paraview) {
  for (const auto& contact : scene.contacts) columns_.contacts.push_back(contact.name);
  for (const auto& support : scene.supports)
    columns_.supports.push_back({support.name, support.rigid && scene.analysis != base::Analysis::axisymmetric});
  for (const auto& bond : scene.bonds) columns_.bonds.push_back(bond.name);
}

void RunWriter::begin() { folder_.begin(history_header(columns_, folder_.identity().analysis)); }

void RunWriter::increment(const sim::IncrementRecord& record) { folder_.add_history(history_row(record)); }

void RunWriter::remesh(const sim::RemeshRecord& record) {
  folder_.add_remesh(remesh_header(folder_.identity().analysis), remesh_row(record));
}

void RunWriter::frame(const sim::Frame& frame) {
  const std::size_t index = folder_.begin_frame(frame.cycle);
  for (const auto* surfaces : {&frame.surfaces, &frame.bonds})
    for (const auto& surface : *surfaces)
      folder_.add_surface(surface_file(surface.contact, surface.side), surface_header(),
                          surface_rows(index, frame, surface), surface.arc_length_mm.size());
  if (folder_.paraview()) folder_.write_frame(bodies_vtu(frame), surfaces_vtp(frame));
}

void RunWriter::finish(const sim::Summary& summary) {
  folder_.put("summary.json", summary_json(summary));
  folder_.make_report([&] { write_report(dir()); });
}

}  // namespace reye::output
