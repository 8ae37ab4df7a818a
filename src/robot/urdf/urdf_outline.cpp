// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the XML with tinyxml2.
#include "robot/urdf/urdf_outline.h"

#include <tinyxml2.h>

#include <algorithm>
#include <set>

namespace link_bounds {
namespace {

/// An eighth of the depth that fills a stack of 8 MB.
constexpr std::size_t kMaxMalformedDepth = 4000;

/// A material may be defined elsewhere, so urdfdom could not parse the element alone with it.
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

/// urdfdom refuses two links of one name. If it accepts the text, it has read it in another way.
bool hasEqualNames(const std::vector<LinkOutline>& links) {
  std::set<std::string> names;
  const auto is_repeated = [&](const LinkOutline& link) { return !names.insert(link.name).second; };
  return std::any_of(links.begin(), links.end(), is_repeated);
}

/// An upper bound of the depth to which urdfdom may recurse in XML that tinyxml2 refuses.
std::size_t countStarts(const std::string& xml) {
  std::size_t starts = 0;
  for (std::size_t i = 0; i + 1 < xml.size(); ++i) {
    if (xml[i] == '<' && xml[i + 1] != '/') ++starts;
  }
  return starts;
}

}  // namespace

/// Some real files have a comment before the XML declaration, which tinyxml2 does not tolerate.
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

std::vector<LinkOutline> outlineOf(const std::string& urdf) {
  tinyxml2::XMLDocument document;
  document.Parse(fromFirstElement(urdf).c_str());
  if (document.ErrorID() == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) {
    throw RobotError("the robot description nests XML elements too deeply; flatten it");
  }
  if (document.Error() && countStarts(urdf) > kMaxMalformedDepth) {
    throw RobotError(
        "the robot description is not well-formed XML, and too long to be read nevertheless; "
        "correct it");
  }
  const tinyxml2::XMLElement* robot = document.FirstChildElement("robot");
  if (document.Error() || !robot) return {};
  std::vector<LinkOutline> links;
  for (const auto* link = robot->FirstChildElement("link"); link;
       link = link->NextSiblingElement("link")) {
    const char* name = link->Attribute("name");
    if (name) links.push_back({name, childrenOf(*link, "visual"), childrenOf(*link, "collision")});
  }
  if (hasEqualNames(links)) return {};
  return links;
}

}  // namespace link_bounds
