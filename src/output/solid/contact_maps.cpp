#include "output/solid/contact_maps.hpp"

#include <algorithm>
#include <optional>

#include "output/folder/text.hpp"
#include "output/report/profiles.hpp"
#include "output/solid/map_figures.hpp"

namespace reye::output {

namespace {

/// A frame, and what of it decides whether it is shown.
struct FrameOfContact {
  std::size_t index = 0;
  double cycle = 0.0, most_MPa = 0.0, tangential_N = 0.0;
};

std::vector<FrameOfContact> frames_of_contact(const SolidRunData& data, const std::string& contact) {
  constexpr std::size_t most_frames = 60;
  std::vector<FrameOfContact> frames;
  for (const std::size_t k : evenly_chosen(data.frames, most_frames)) {
    const auto skins = skins_of(data, k);
    const auto* skin = secondary_of(skins, contact);
    if (!skin) continue;
    base::Vec3 shear = base::Vec3::Zero();
    for (std::size_t i = 0; i < skin->X.size(); ++i) shear += skin->area_mm2[i] * skin->shear_MPa[i];
    frames.push_back({k, skins.cycle, largest(skin->pressure_MPa), shear.norm()});
  }
  return frames;
}

/// "frame 12, cycle 3"
std::string when_of(const FrameOfContact& frame) {
  return "frame " + std::to_string(frame.index) + (frame.cycle > 0.0 ? ", cycle " + rounded(frame.cycle, 8) : "");
}

MapWords words_for(const SolidRunData& data, const std::string& contact, const FrameOfContact& frame,
                   const std::string& set) {
  const auto friction = data.run.identity.friction.find(contact);
  return {file_part(contact) + set, before_titles(data, contact), when_of(frame),
          friction == data.run.identity.friction.end() ? std::nullopt : friction->second};
}

/// A value of one side.
struct MovingValue {
  bool secondary = true;
  std::vector<double> DrawnSkin::*rows;
};

/// Adds the value over the frames, if it is ever above zero and there are two frames of it.
void add_moving(const std::vector<DrawnSkins>& frames, const std::string& contact, const MovingValue& value,
                const std::string& id, const std::string& title, std::vector<Figure>& all) {
  const bool depth = value.rows == &DrawnSkin::wear_depth_mm;
  double most = 0.0;
  std::vector<MovingMap> moving;
  for (const auto& frame : frames)
    for (const auto& skin : frame.all)
      if (skin.contact == contact && skin.secondary == value.secondary) {
        const auto& rows = skin.*value.rows;
        most = std::max(most, largest(rows));
        moving.push_back(
            {depth ? skin_map(skin, worn_rows(skin)) : skin_map(skin), rows, "cycle " + rounded(frame.cycle, 6)});
      }
  if (moving.size() < 2 || !(most > 0.0) || moving.back().map.triangles.empty()) return;
  const Unit unit = depth ? length_unit(most) : Unit{1.0, "MPa"};
  for (auto& frame : moving)
    for (double& row : frame.rows) row *= unit.factor;
  all.push_back(moving_map(moving, unit.name, id, title));
}

}  // namespace

std::vector<Figure> contact_maps(const SolidRunData& data, const std::string& contact) {
  constexpr double clearly_more = 1.05;
  std::vector<Figure> all;
  const auto frames = frames_of_contact(data, contact);
  const auto pressed = std::find_if(frames.rbegin(), frames.rend(), [](const auto& f) { return f.most_MPa > 0.0; });
  if (pressed == frames.rend()) return all;
  const auto last = skins_of(data, pressed->index);
  const DrawnSkin& skin = *secondary_of(last, contact);
  const SkinMap map = skin_map(skin);
  if (map.triangles.empty()) return all;
  const MapWords words = words_for(data, contact, *pressed, "");
  const bool rubs = words.friction.value_or(1.0) > 0.0;
  all.push_back(pressure_map(map, skin, words));
  if (rubs)
    for (const auto draw : {status_map, shear_map, slip_map}) all.push_back(draw(map, skin, words));
  for (auto& profile : line_profiles(map, skin, words)) all.push_back(std::move(profile));
  const auto hardest = std::max_element(frames.begin(), frames.end(),
                                        [](const auto& a, const auto& b) { return a.tangential_N < b.tangential_N; });
  if (!rubs || !(hardest->tangential_N > clearly_more * pressed->tangential_N)) return all;
  const auto then = skins_of(data, hardest->index);
  const DrawnSkin& rubbed = *secondary_of(then, contact);
  MapWords most = words_for(data, contact, *hardest, "-most");
  most.when += ", largest shear force";
  const SkinMap its_map = skin_map(rubbed);
  if (its_map.triangles.empty()) return all;
  for (const auto draw : {status_map, shear_map}) all.push_back(draw(its_map, rubbed, most));
  return all;
}

std::vector<Figure> depth_maps(const SolidRunData& data, const std::string& contact) {
  std::vector<Figure> all;
  if (data.frames == 0) return all;
  const auto skins = skins_of(data, data.frames - 1);
  for (const auto& skin : skins.all) {
    if (skin.contact != contact || !(largest(skin.wear_depth_mm) > 0.0)) continue;
    const SkinMap map = skin_map(skin, worn_rows(skin));
    if (!map.triangles.empty())
      all.push_back(depth_map(
          map, skin, words_for(data, contact, {data.frames - 1, skins.cycle}, skin.secondary ? "" : "-primary")));
  }
  return all;
}

std::vector<Figure> moving_maps(const SolidRunData& data, const std::string& contact) {
  constexpr std::size_t most_frames = 40;
  std::vector<Figure> all;
  if (data.frames < 2) return all;
  std::vector<DrawnSkins> frames;
  for (const std::size_t k : evenly_chosen(data.frames, most_frames)) frames.push_back(skins_of(data, k));
  const std::string before = before_titles(data, contact), id = file_part(contact);
  add_moving(frames, contact, {true, &DrawnSkin::pressure_MPa}, "moving-pressure-" + id, before + "pressure", all);
  add_moving(frames, contact, {true, &DrawnSkin::wear_depth_mm}, "moving-depth-" + id,
             before + "worn depth, secondary side", all);
  add_moving(frames, contact, {false, &DrawnSkin::wear_depth_mm}, "moving-depth-" + id + "-primary",
             before + "worn depth, primary side", all);
  return all;
}

}  // namespace reye::output
