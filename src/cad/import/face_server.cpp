#include "cad/import/face_server.hpp"

#include "cad/import/answer_each.hpp"
#include "cad/meshing/kernel.hpp"
#include "cad/meshing/region_bytes.hpp"

namespace reye::cad {

void serve_faces(const Reading& how) {
  answer_each(how, [](const std::string& request) {
    return bytes_of(mesh_or_failure<FilledRegion>([&] {
      RegionToFill asked = region_to_fill_of(request);
      kernel().fill(asked.region, asked.size);
      return std::move(asked.region);
    }));
  });
}

}  // namespace reye::cad
