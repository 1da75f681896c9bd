#pragma once
#include <vtkDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkZLibDataCompressor.h>

#include <stdexcept>
#include <string>
#include <vector>

/// Pieces of every ParaView file of the output, for the two sources that write them.
namespace reye::output {

using Names = std::vector<const char*>;

/// A point or cell array under construction.
template <class Array>
vtkNew<Array> make_array(const char* name, const Names& components = {}) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components.empty() ? 1 : static_cast<int>(components.size()));
  for (std::size_t i = 0; i < components.size(); ++i) array->SetComponentName(static_cast<vtkIdType>(i), components[i]);
  return array;
}

inline vtkNew<vtkPoints> make_points() {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  return points;
}

/// Inline binary, since appended data cannot be opened with some versions of the XML parser.
template <class Writer>
std::string written(vtkDataSet* data) {
  vtkNew<Writer> writer;
  vtkNew<vtkZLibDataCompressor> compressor;
  compressor->SetCompressionLevel(1);
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressor(compressor);
  writer->SetWriteToOutputString(true);
  if (!writer->Write()) throw std::runtime_error("a ParaView frame could not be encoded");
  return writer->GetOutputString();
}

}  // namespace reye::output
