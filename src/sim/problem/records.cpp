#include "sim/problem/records.hpp"

namespace reye::sim {

IncrementRecord::IncrementRecord() = default;
IncrementRecord::IncrementRecord(const IncrementRecord&) = default;
IncrementRecord::IncrementRecord(IncrementRecord&&) noexcept = default;
IncrementRecord& IncrementRecord::operator=(const IncrementRecord&) = default;
IncrementRecord& IncrementRecord::operator=(IncrementRecord&&) noexcept = default;
IncrementRecord::~IncrementRecord() = default;

SurfaceRecord::SurfaceRecord() = default;
SurfaceRecord::SurfaceRecord(const SurfaceRecord&) = default;
SurfaceRecord::SurfaceRecord(SurfaceRecord&&) noexcept = default;
SurfaceRecord& SurfaceRecord::operator=(const SurfaceRecord&) = default;
SurfaceRecord& SurfaceRecord::operator=(SurfaceRecord&&) noexcept = default;
SurfaceRecord::~SurfaceRecord() = default;

Summary::Summary() = default;
Summary::Summary(const Summary&) = default;
Summary::Summary(Summary&&) noexcept = default;
Summary& Summary::operator=(const Summary&) = default;
Summary& Summary::operator=(Summary&&) noexcept = default;
Summary::~Summary() = default;

BodyFrame::BodyFrame() = default;
BodyFrame::BodyFrame(const BodyFrame&) = default;
BodyFrame::BodyFrame(BodyFrame&&) noexcept = default;
BodyFrame& BodyFrame::operator=(const BodyFrame&) = default;
BodyFrame& BodyFrame::operator=(BodyFrame&&) noexcept = default;
BodyFrame::~BodyFrame() = default;

}  // namespace reye::sim
