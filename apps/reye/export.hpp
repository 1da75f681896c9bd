#pragma once
#include "output/export/export.hpp"

namespace reye::apps {

struct ExportRequest : output::ShapeWish {
  std::string out;  ///< file to write; empty: ./<run>_cycle_<cycle>.<format>
  bool list = false, force = false;
};

/// `reye export`: writes the worn shape of a run. A file in its place is replaced where it is a former export, or with
/// `force`. Throws base::InputError, and has written nothing then.
int export_shape(const ExportRequest& request);

}  // namespace reye::apps
