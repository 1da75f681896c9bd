#include <vtk-9.1/vtkCellData.h>
#include <vtk-9.1/vtkDataArray.h>
#include <vtk-9.1/vtkFieldData.h>
#include <vtk-9.1/vtkIdList.h>
#include <vtk-9.1/vtkNew.h>
#include <vtk-9.1/vtkPointData.h>
#include <vtk-9.1/vtkPolyData.h>
#include <vtk-9.1/vtkSmartPointer.h>
#include <vtk-9.1/vtkUnstructuredGrid.h>
#include <vtk-9.1/vtkXMLDataElement.h>
#include <vtk-9.1/vtkXMLPolyDataReader.h>
#include <vtk-9.1/vtkXMLUnstructuredGridReader.h>
#include <vtk-9.1/vtkXMLUtilities.h>

#include <map>
#include <set>

#include "command.hpp"
#include "output/report/run_data.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

struct Entry {
  double time = 0.0;
  std::string file;
};

/// A collection, read as XML.
std::vector<Entry> entries(const test::fs::path& pvd) {
  std::vector<Entry> all;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(pvd.c_str()));
  if (!root || !root->FindNestedElementWithName("Collection")) return all;
  auto* collection = root->FindNestedElementWithName("Collection");
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    auto* set = collection->GetNestedElement(i);
    Entry entry{-1.0, set->GetAttribute("file")};
    set->GetScalarAttribute("timestep", entry.time);
    all.push_back(entry);
  }
  return all;
}

/// A pin that is worn flat, its contact growing to three times its first fine zone; both bodies remeshed after each
/// cycle, a frame at each.
struct WornPin {
  static constexpr int cycles = 6;  ///< of the scene
  test::Place place;

  WornPin() {
    place.write("wearing.geo", test::wearing_geo);
    place.write("pin.toml", test::worn_pin);
    const auto told = place.reye({"run", "pin.toml", "--out", "o", "--quiet"});
    EXPECT_EQ(told.code, 0) << told.err;
  }

  /// Every frame of a series by VTK's own reader.
  template <class Reader>
  auto frames(const std::string& pvd) const {
    std::vector<vtkSmartPointer<std::remove_pointer_t<decltype(Reader::New()->GetOutput())>>> all;
    for (const auto& entry : entries(place / ("o/" + pvd))) {
      const auto file = place / ("o/" + entry.file);
      EXPECT_TRUE(test::fs::is_regular_file(file)) << file;
      vtkNew<Reader> reader;
      EXPECT_TRUE(reader->CanReadFile(file.c_str())) << file;
      reader->SetFileName(file.c_str());
      reader->Update();
      all.emplace_back(reader->GetOutput());
    }
    return all;
  }
  auto bodies() const { return frames<vtkXMLUnstructuredGridReader>("series.pvd"); }
  auto surfaces() const { return frames<vtkXMLPolyDataReader>("surfaces.pvd"); }
  output::Table remeshes() const { return output::parse_csv(test::read(place / "o/remesh.csv")); }
};

/// What a pipeline made on one frame needs to find on all: name, type and component names of each array.
std::vector<std::string> arrays_of(vtkFieldData* data) {
  std::vector<std::string> all;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    auto* array = data->GetAbstractArray(i);
    std::string text = std::string(array->GetName()) + ' ' + array->GetDataTypeAsString();
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      text += std::string(" ") + (array->GetComponentName(c) ? array->GetComponentName(c) : "-");
    all.push_back(text);
  }
  return all;
}

void expect_length(vtkFieldData* data, vtkIdType length) {
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    EXPECT_EQ(data->GetAbstractArray(i)->GetNumberOfTuples(), length) << data->GetAbstractArray(i)->GetName();
}

/// Every cell has its points, and every point a cell.
void expect_cells_within_points(vtkDataSet* frame) {
  vtkNew<vtkIdList> ids;
  std::set<vtkIdType> met;
  for (vtkIdType cell = 0; cell < frame->GetNumberOfCells(); ++cell) {
    frame->GetCellPoints(cell, ids);
    met.insert(ids->begin(), ids->end());
  }
  ASSERT_FALSE(met.empty());
  EXPECT_GE(*met.begin(), 0);
  EXPECT_LT(*met.rbegin(), frame->GetNumberOfPoints());
  EXPECT_EQ(static_cast<vtkIdType>(met.size()), frame->GetNumberOfPoints());
}

template <class Frames>
void expect_one_series(const std::vector<Entry>& listed, const Frames& frames) {
  ASSERT_EQ(frames.size(),
            static_cast<std::size_t>(WornPin::cycles) + 2);  // before and after the load step, then each cycle
  for (std::size_t k = 0; k < frames.size(); ++k) {
    SCOPED_TRACE(listed[k].file);
    const double cycle = k < 2 ? 0.0 : static_cast<double>(k - 1);
    EXPECT_EQ(listed[k].time, k == 1 ? 1e-6 : cycle);
    EXPECT_EQ(frames[k]->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), cycle);
    EXPECT_EQ(arrays_of(frames[k]->GetPointData()), arrays_of(frames[0]->GetPointData()));
    EXPECT_EQ(arrays_of(frames[k]->GetCellData()), arrays_of(frames[0]->GetCellData()));
    EXPECT_EQ(arrays_of(frames[k]->GetFieldData()), arrays_of(frames[0]->GetFieldData()));
    expect_length(frames[k]->GetPointData(), frames[k]->GetNumberOfPoints());
    expect_length(frames[k]->GetCellData(), frames[k]->GetNumberOfCells());
    expect_cells_within_points(frames[k]);
  }
}

/// Nodes of each body at the end of a cycle, by the table of remeshes.
std::map<std::string, double> nodes_at(const output::Table& remeshes, double cycle) {
  std::map<std::string, double> nodes;
  for (std::size_t i = 0; i < remeshes.rows(); ++i) {
    const auto& body = remeshes.word(remeshes.column("body")[i]);
    const bool later = remeshes.column("cycle")[i] > cycle;
    if (!later) nodes[body] = remeshes.column("nodes_after")[i];
    nodes.try_emplace(body, remeshes.column("nodes_before")[i]);
  }
  return nodes;
}

/// The largest depth on the points of the cells whose array `of` is `index`.
double deepest(vtkDataSet* frame, const char* of, int index) {
  auto* depth = frame->GetPointData()->GetArray("wear_depth_mm");
  vtkNew<vtkIdList> ids;
  double largest = 0.0;
  for (vtkIdType cell = 0; cell < frame->GetNumberOfCells(); ++cell) {
    if (frame->GetCellData()->GetArray(of)->GetComponent(cell, 0) != index) continue;
    frame->GetCellPoints(cell, ids);
    for (const vtkIdType id : *ids) largest = std::max(largest, depth->GetComponent(id, 0));
  }
  return largest;
}

}  // namespace

// A series of bodies whose meshes change must read back frame by frame: times, arrays, cells, and as many nodes as the
// table of remeshes says.
TEST(Series, BodiesReadBackThroughRemeshes) {
  const WornPin run;
  const auto frames = run.bodies();
  expect_one_series(entries(run.place / "o/series.pvd"), frames);
  const auto remeshes = run.remeshes();
  EXPECT_GE(remeshes.rows(), 2u * WornPin::cycles);
  std::set<vtkIdType> counts;
  for (const auto& frame : frames) {
    counts.insert(frame->GetNumberOfPoints());
    double nodes = 0.0;
    for (const auto& [body, count] :
         nodes_at(remeshes, frame->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0)))
      nodes += count;
    EXPECT_EQ(static_cast<double>(frame->GetNumberOfPoints()), nodes);
  }
  EXPECT_GE(counts.size(), 3u);
}

// The contact surfaces must read back likewise.
TEST(Series, SurfacesReadBackThroughRemeshes) {
  const WornPin run;
  const auto frames = run.surfaces();
  expect_one_series(entries(run.place / "o/surfaces.pvd"), frames);
  std::set<vtkIdType> counts;
  for (const auto& frame : frames) counts.insert(frame->GetNumberOfPoints());
  EXPECT_GE(counts.size(), 2u);
}

// The moving pictures of a run must have a moment for each of its frames, also where meshes change, and stand in its
// page.
TEST(Series, AnimationHasItsFrames) {
  const WornPin run;
  const auto told = run.place.reye({"report", "o", "--animation"});
  ASSERT_EQ(told.code, 0) << told.err;
  const auto page = test::read(run.place / "o/report.html");
  for (const char* id : {"moving-bodies-pad", "moving-pressure-pad", "moving-depth-pad"}) {
    const auto picture = test::read(run.place / ("o/figures/" + std::string(id) + ".svg"));
    std::size_t moments = 0;
    for (auto at = picture.find("class=\"moment\""); at != std::string::npos;
         at = picture.find("class=\"moment\"", at + 1))
      ++moments;
    EXPECT_EQ(moments, entries(run.place / "o/series.pvd").size()) << id;
    EXPECT_TRUE(test::holds(page, picture)) << id;
  }
}

// No remesh may heal a worn surface: at its deepest place the depth grows from frame to frame, the same in both series.
TEST(Series, DepthGrowsThroughRemeshes) {
  const WornPin run;
  const auto bodies = run.bodies();
  const auto surfaces = run.surfaces();
  ASSERT_EQ(bodies.size(), surfaces.size());
  for (const int side : {0, 1}) {  // the disc is the first body and the secondary side
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const double depth = deepest(bodies[k], "body", side);
      EXPECT_EQ(depth, deepest(surfaces[k], "side", side)) << "frame " << k;
      if (k < 2)
        EXPECT_EQ(depth, 0.0);
      else
        EXPECT_GT(depth, deepest(bodies[k - 1], "body", side)) << "frame " << k << " of side " << side;
    }
  }
}

// Without files for ParaView the tables must be those of the same run with them, to the last byte.
TEST(Series, TablesAlone) {
  const test::Place place;
  place.write("blocks.geo", test::blocks_geo);
  for (const char* name : {"with", "without"})
    place.write(std::string(name) + ".toml", std::string(test::blocks) +
                                                 "[output]\nframes = { every_increment = true, paraview = " +
                                                 (std::string(name) == "with" ? "true" : "false") + " }\n");
  for (const char* name : {"with", "without"})
    ASSERT_EQ(place.reye({"run", std::string(name) + ".toml", "--out", name, "--quiet"}).code, 0);
  for (const char* file : {"surface_pad_secondary.csv", "surface_pad_primary.csv", "history.csv"})
    EXPECT_EQ(test::read(place / "with" / file), test::read(place / "without" / file)) << file;
  EXPECT_TRUE(test::fs::exists(place / "with/series.pvd"));
  EXPECT_FALSE(test::fs::exists(place / "without/series.pvd"));
  EXPECT_TRUE(test::fs::is_empty(place / "without/frames"));
  EXPECT_TRUE(test::holds(place.reye({"plan", "without.toml"}).out, "interior solved back never"));
}
