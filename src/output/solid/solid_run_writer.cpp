#include "output/solid/solid_run_writer.hpp"

#include <filesystem>

#include "output/folder/files.hpp"
#include "output/folder/tables.hpp"
#include "output/solid/solid_picture.hpp"
#include "output/solid/solid_report.hpp"
#include "output/solid/solid_summary.hpp"
#include "output/solid/solid_tables.hpp"
#include "output/solid/solid_vtk.hpp"

namespace reye::output {

SolidRunWriter::SolidRunWriter(std::string dir, const scene::SolidScene& scene)
    : scene_(scene),
      folder_(std::move(dir), identity_of(scene), scene.frames.paraview),
      inputs_(inputs_of(scene)),
      columns_{inputs_.contacts, inputs_.supports} {
  for (const auto& body : scene.geometry.bodies) bodies_.push_back(body.name);
}

void SolidRunWriter::begin() {
  folder_.begin(solid_history_header(columns_));
  folder_.put("inputs.json", inputs_json(inputs_));
}

void SolidRunWriter::resume(const Counters& counters) {
  folder_.resume(counters);
  folder_.put("inputs.json", inputs_json(inputs_));
}

void SolidRunWriter::increment(const sim::SolidIncrement& record) {
  folder_.add_history(solid_history_row(record, columns_));
}

void SolidRunWriter::remesh(const sim::SolidRemeshRecord& record) {
  folder_.add_remesh(solid_remesh_header(), solid_remesh_row(record));
}

void SolidRunWriter::frame(const sim::SolidFrame& frame) {
  if (!folder_.in_memory() && !std::filesystem::exists(folder_.path("scene.svg"))) draw_scene(frame);
  const std::size_t index = folder_.begin_frame(frame.cycle);
  for (const auto& skin : frame.surfaces)
    folder_.add_surface(surface_file(skin.contact, skin.side), skin_header(),
                        skin_rows(index, frame.cycle, bodies_, skin), skin.x_mm.size());
  if (folder_.paraview()) folder_.write_frame(solid_bodies_vtu(frame), skins_vtp(frame));
}

void SolidRunWriter::draw_scene(const sim::SolidFrame& frame) const {
  std::vector<const mesh::SolidMesh*> bodies;
  for (const auto& body : frame.bodies) bodies.push_back(body.mesh.get());
  if (bodies.size() == scene_.geometry.bodies.size())
    atomic_write(folder_.path("scene.svg"), solid_picture(scene_, bodies));
}

void SolidRunWriter::finish(const sim::SolidSummary& summary) {
  folder_.put("summary.json", solid_summary_json(summary));
  folder_.make_report([&] { write_solid_report(dir()); });
}

}  // namespace reye::output
