// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Walks the XML with tinyxml2.
#include "urdf_outline.h"

#include <tinyxml2.h>

namespace link_bounds {
namespace {

/// Whether a material is defined elsewhere must not matter when an element is looked at alone.
std::string printedWithoutMaterial(const tinyxml2::XMLElement& element) {
  tinyxml2::XMLDocument document;
  tinyxml2::XMLNode* copy = element.DeepClone(&document);
  document.InsertEndChild(copy);
  while (tinyxml2::XMLElement* material = copy->FirstChildElement("material")) {
    copy->DeleteChild(material);
  }
  tinyxml2::XMLPrinter printer(nullptr, true);
  document.Print(&printer);
  return printer.CStr();
}

std::vector<std::string> childrenOf(const tinyxml2::XMLElement& link, const char* tag) {
  std::vector<std::string> result;
  for (const auto* element = link.FirstChildElement(tag); element;
       element = element->NextSiblingElement(tag)) {
    result.push_back(printedWithoutMaterial(*element));
  }
  return result;
}

/// The text from the first element on: some real files have a comment before the XML declaration,
/// which urdfdom tolerates and tinyxml2 does not.
std::string fromFirstElement(const std::string& urdf) {
  std::size_t begin = urdf.find('<');
  while (begin != std::string::npos && begin + 1 < urdf.size()) {
    const bool is_comment = urdf.compare(begin, 4, "<!--") == 0;
    if (!is_comment && urdf[begin + 1] != '?' && urdf[begin + 1] != '!') return urdf.substr(begin);
    const std::size_t end = urdf.find(is_comment ? "-->" : ">", begin);
    begin = end == std::string::npos ? end : urdf.find('<', end);
  }
  return "";
}

}  // namespace

std::vector<LinkOutline> outlineOf(const std::string& urdf) {
  tinyxml2::XMLDocument document;
  document.Parse(fromFirstElement(urdf).c_str());
  if (document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    throw RobotError("the robot description nests XML elements too deeply; flatten it");
  }
  const tinyxml2::XMLElement* robot = document.FirstChildElement("robot");
  if (document.Error() || !robot) return {};
  std::vector<LinkOutline> links;
  for (const auto* link = robot->FirstChildElement("link"); link;
       link = link->NextSiblingElement("link")) {
    const char* name = link->Attribute("name");
    if (name) links.push_back({name, childrenOf(*link, "visual"), childrenOf(*link, "collision")});
  }
  return links;
}

}  // namespace link_bounds
