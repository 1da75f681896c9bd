#pragma once
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkFieldData.h>
#include <vtkNew.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"

/// Pieces of reading ParaView files back, for the two sources that do; all throw base::InputError with the path.
namespace reye::output {

[[noreturn]] inline void damaged_frame(const std::string& path) {
  throw base::InputError({{"dir", "", path + " is damaged: it is not a frame of a run"}});
}

/// The arrays that a reader takes of points and of cells; others stay packed in the file. Without them it takes all.
struct WantedArrays {
  std::vector<const char*> of_points, of_cells;
};

inline void choose(vtkDataArraySelection& selection, const std::vector<const char*>& wanted) {
  selection.RemoveAllObservers();  // or the reader parses the file again
  selection.DisableAllArrays();
  for (const char* name : wanted)
    if (selection.ArrayExists(name)) selection.EnableArray(name);
}

/// The text of the file at `path`. Throws where one of its arrays would be unpacked to more than its bytes can hold,
/// for which the reader would take all memory: a digit of its sizes is damaged.
std::string text_of_possible_sizes(const std::string& path);

template <class Reader>
vtkNew<Reader> opened(const std::string& path, const std::optional<WantedArrays>& wanted = {}) {
  vtkNew<Reader> reader;
  if (!std::filesystem::is_regular_file(path) || !reader->CanReadFile(path.c_str())) damaged_frame(path);
  vtkObject::GlobalWarningDisplayOff();  // its error is reported below
  reader->ReadFromInputStringOn();
  reader->SetInputString(text_of_possible_sizes(path));
  try {
    reader->UpdateInformation();
    if (wanted) choose(*reader->GetPointDataArraySelection(), wanted->of_points);
    if (wanted) choose(*reader->GetCellDataArraySelection(), wanted->of_cells);
    reader->Update();
  } catch (const std::exception&) {  // sizes that no memory holds
    damaged_frame(path);
  }
  if (reader->GetErrorCode() != 0 || reader->GetOutput() == nullptr) damaged_frame(path);
  return reader;
}

/// The array of so many rows, all finite.
inline vtkDataArray& array_of(vtkFieldData& data, const char* name, vtkIdType rows, const std::string& path) {
  auto* array = data.GetArray(name);
  if (!array || array->GetNumberOfTuples() < rows || array->GetNumberOfComponents() < 1) damaged_frame(path);
  for (vtkIdType i = 0; i < rows; ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      if (!std::isfinite(array->GetComponent(i, c))) damaged_frame(path);
  return *array;
}

inline std::vector<double> values_of(vtkDataArray& array) {
  std::vector<double> values;
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) values.push_back(array.GetComponent(i, 0));
  return values;
}

}  // namespace reye::output
