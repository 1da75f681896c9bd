#include "cad/import/solid_server.hpp"

#include <new>

#include "base/errors.hpp"
#include "cad/import/answer_each.hpp"
#include "cad/import/read_vtu.hpp"
#include "cad/solid/solid_bytes.hpp"
#include "cad/solid/solid_file.hpp"
#include "cad/solid/solid_kernel.hpp"

namespace reye::cad {

namespace {

std::vector<RawSolid> read_solids(const std::string& file, const Reading& how, const Points3& probes) {
  const Format format = checked_format(file, how);
  return format == Format::vtu ? read_vtu_solids(file) : solid_kernel().open(file, format, probes);
}

SolidAnswer answer_to(const SolidQuery& query, const std::string& file, const Reading& how) {
  const auto refused = [&](const std::string& rule) {
    return SolidAnswer{{}, {{"geometry", "\"" + file + "\"", rule}}};
  };
  try {
    return {read_solids(file, how, query.probes), {}};
  } catch (const base::InputError& error) {
    return {{}, error.issues()};
  } catch (const std::bad_alloc&) {
    return refused("reading it takes more than 3 GB of memory");
  } catch (const std::exception& error) {
    return refused(std::string("cannot be read: ") + error.what());
  } catch (...) {
    return refused("cannot be read");
  }
}

}  // namespace

void serve_solids(const std::string& file, const Reading& how) {
  const auto query = next_request();
  if (!query) return;
  if (!how.trusted) limit_computing(computing_s);
  say(bytes_of(answer_to(solid_query_of(*query), file, how)));
  answer_each(how, [](const std::string& order) {
    return bytes_of(mesh_or_failure<SolidMeshAnswer>([&] { return solid_kernel().mesh(solid_order_of(order)); }));
  });
}

void serve_fillings(const Reading& how) {
  answer_each(how, [](const std::string& filling) {
    return bytes_of(mesh_or_failure<SolidMeshAnswer>([&] { return solid_kernel().fill(skin_filling_of(filling)); }));
  });
}

}  // namespace reye::cad
