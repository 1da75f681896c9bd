#pragma once
#include <vtk-9.1/vtkNew.h>
#include <vtk-9.1/vtkXMLDataParser.h>

#include <string>

namespace sample {

/// Whether an XML parser accepts the text.
inline bool well_formed(const std::string& xml) {
  vtkNew<vtkXMLDataParser> parser;
  return parser->vtkXMLParser::Parse(xml.c_str(), static_cast<unsigned>(xml.size())) != 0;
}

}  // namespace sample
