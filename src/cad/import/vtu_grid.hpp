#pragma once
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

/// The grid in a .vtu, checked before use. All throw base::InputError (key "geometry").
namespace reye::cad {

vtkSmartPointer<vtkUnstructuredGrid> open_vtu(const std::string& path);

/// The texts of an array of the whole grid; none where there is no such array.
std::vector<std::string> names_in(vtkUnstructuredGrid& grid, const char* array);

/// Values of a cell array, `otherwise` where there is none.
std::vector<int> values_in(vtkUnstructuredGrid& grid, const char* array, int otherwise);

/// The nodes of every cell by number in the file, as many as its kind has where that is read here.
std::vector<std::vector<int>> nodes_of_cells(vtkUnstructuredGrid& grid, const std::string& path);

/// Where the points are: on X where the file says that, else as drawn; three components each.
vtkDataArray& positions_in(vtkUnstructuredGrid& grid, const std::string& path);

/// The points that the cells of a body refer to, in the order of the file.
class UsedPoints {
 public:
  void add(const std::vector<int>& points) { used_.insert(used_.end(), points.begin(), points.end()); }
  /// To be called once all are added.
  void number();
  const std::vector<int>& all() const { return used_; }
  int place(int point) const;  ///< -1 for a point of no cell

 private:
  std::vector<int> used_;
};

}  // namespace reye::cad
