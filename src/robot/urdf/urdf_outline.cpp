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

/// True if it has two children with this tag, or with any tags if `tag` is null.
bool hasTwo(const tinyxml2::XMLElement& element, const char* tag) {
  const tinyxml2::XMLElement* const first = element.FirstChildElement(tag);
  return first && first->NextSiblingElement(tag);
}

std::string twoOf(const char* tag) {
  return std::string("has two <") + tag + ">, of which the second is left out; ";
}

std::string surplusOf(const tinyxml2::XMLElement& element) {
  const std::string another =
      "write another shape as a <" + std::string(element.Name()) + "> of its own";
  const tinyxml2::XMLElement* const geometry = element.FirstChildElement("geometry");
  if (geometry && hasTwo(*geometry, nullptr))
    return "its <geometry> has two shapes, of which the second is left out; " + another;
  if (hasTwo(element, "geometry")) return "it " + twoOf("geometry") + another;
  if (hasTwo(element, "origin")) return "it " + twoOf("origin") + "remove one";
  return "";
}

std::vector<ElementOutline> childrenOf(const tinyxml2::XMLElement& link, const char* tag) {
  std::vector<ElementOutline> result;
  for (const auto* element = link.FirstChildElement(tag); element;
       element = element->NextSiblingElement(tag)) {
    result.push_back({printedWithoutMaterial(*element), surplusOf(*element)});
  }
  return result;
}

std::vector<std::string> jointWarnings(const tinyxml2::XMLElement& robot) {
  std::vector<std::string> warnings;
  for (const auto* joint = robot.FirstChildElement("joint"); joint;
       joint = joint->NextSiblingElement("joint")) {
    for (const char* const tag : {"parent", "child", "origin", "axis", "limit", "mimic"}) {
      const char* const name = joint->Attribute("name");
      if (name && hasTwo(*joint, tag))
        warnings.push_back("joint \"" + std::string(name) + "\" " + twoOf(tag) + "remove one");
    }
  }
  return warnings;
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

RobotOutline outlineOf(const std::string& urdf) {
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
  return {std::move(links), jointWarnings(*robot)};
}

}  // namespace link_bounds
