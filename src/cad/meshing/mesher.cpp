#include "cad/meshing/mesher.hpp"

#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "base/errors.hpp"
#include "cad/meshing/kernel.hpp"
#include "cad/meshing/region.hpp"
#include "cad/meshing/region_bytes.hpp"

namespace reye::cad {

namespace {

/// The process in which gmsh runs, and how long it may keep this one waiting.
struct Mesher {
  std::unique_ptr<ImporterProcess> process;
  double most_s = std::numeric_limits<double>::infinity();
  std::mutex one_at_a_time;
};

Mesher& mesher() {
  static Mesher only;
  return only;
}

const Task meshing{"meshing it", "meshes", meshing_s, waiting_for_mesh_s};

/// One that has read nothing: the region is this program's own, and may take as long as it takes.
void start(Mesher& mesher) {
  mesher.process = std::make_unique<ImporterProcess>(std::vector<std::string>{"trusted", "-", "faces", "-"});
  mesher.most_s = std::numeric_limits<double>::infinity();
  if (mesher.process->message(waiting_s)) return;
  kernel();  // says why, where it is gmsh that cannot be loaded
  throw base::MeshError("reye-import does not start: " + mesher.process->end_in_words(meshing));
}

std::optional<std::string> asked(Mesher& mesher, const std::string& request) {
  mesher.process->ask(request);
  return mesher.process->message(mesher.most_s);
}

/// The answer to a request. A process that was there before may be killed with the thread that started it: then one of
/// its own gets the request. One that crashes on it, or takes too long, gets no second try.
std::string answer_to(const std::string& request, Mesher& mesher) {
  const bool was_there = mesher.process && mesher.process->is_own();
  if (!was_there) start(mesher);
  auto bytes = asked(mesher, request);
  if (!bytes && was_there && mesher.process->was_killed()) {
    start(mesher);
    bytes = asked(mesher, request);
  }
  if (bytes) return std::move(*bytes);
  const std::string why = mesher.process->end_in_words(meshing);
  mesher.process.reset();
  throw base::MeshError(why);
}

FilledRegion checked(const std::string& bytes, const Region& asked) {
  try {
    return filled_region_of(bytes, asked);
  } catch (const std::runtime_error& error) {
    throw base::MeshError(std::string("what is made of it ") + error.what());
  }
}

}  // namespace

void mesh_in(std::unique_ptr<ImporterProcess> importer, bool trusted) {
  Mesher& all = mesher();
  const std::lock_guard lock(all.one_at_a_time);
  all.process = std::move(importer);
  all.most_s = trusted ? std::numeric_limits<double>::infinity() : waiting_for_mesh_s;
}

void fill(Region& region, const SizeField& size) {
  Mesher& all = mesher();
  const std::lock_guard lock(all.one_at_a_time);
  FilledRegion answer = checked(answer_to(bytes_of(RegionToFill{region, size}), all), region);
  if (!answer.failure.empty()) throw base::MeshError(answer.failure);
  region = std::move(answer.region);
}

}  // namespace reye::cad
