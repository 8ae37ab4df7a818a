// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// By tinyxml2, which also escapes names.
#include "robot/pairs/srdf.h"

#include <tinyxml2.h>

#include <algorithm>

namespace link_bounds {
namespace {

constexpr char kElement[] = "disable_collisions";

[[noreturn]] void refuse(const std::string& file, int line, const std::string& reason) {
  throw SrdfError("the SRDF \"" + file + "\"" +
                  (line > 0 ? ", line " + std::to_string(line) : std::string()) + ": " + reason);
}

std::string linkOf(const tinyxml2::XMLElement& element, const char* attribute, const Robot& robot,
                   const std::string& file) {
  const char* name = element.Attribute(attribute);
  if (!name) {
    refuse(file, element.GetLineNum(),
           std::string("<") + kElement + "> has no " + attribute + "; name a link there");
  }
  const auto is_it = [name](const Link& link) { return link.name == name; };
  if (std::none_of(robot.links.begin(), robot.links.end(), is_it)) {
    refuse(file, element.GetLineNum(),
           std::string("\"") + name + "\" is no link of the robot \"" + robot.name +
               "\"; give the SRDF of this robot, or correct the name");
  }
  return name;
}

}  // namespace

std::vector<DisabledPair> parseSrdf(const std::string& text, const Robot& robot,
                                    const std::string& file) {
  tinyxml2::XMLDocument document;
  document.Parse(text.c_str(), text.size());
  if (document.Error())
    refuse(file, document.ErrorLineNum(), "it is not well-formed XML; correct it there");
  const tinyxml2::XMLElement* root = document.RootElement();
  if (!root || std::string(root->Name()) != "robot") {
    refuse(file, root ? root->GetLineNum() : 0,
           std::string("the root element is ") + (root ? root->Name() : "missing") +
               ", not <robot>; give a SRDF");
  }
  std::vector<DisabledPair> pairs;
  for (const auto* child = root->FirstChildElement(); child; child = child->NextSiblingElement()) {
    const std::string name = child->Name();
    if (name.rfind("xacro:", 0) == 0) {
      refuse(file, child->GetLineNum(),
             "it is a xacro file, with an element <" + name +
                 ">; expand it by xacro FILE > robot.srdf");
    }
    if (name != kElement) continue;
    const char* reason = child->Attribute("reason");
    pairs.push_back({linkOf(*child, "link1", robot, file), linkOf(*child, "link2", robot, file),
                     reason ? reason : ""});
  }
  return pairs;
}

std::string toSrdf(const DisabledPair& pair) {
  tinyxml2::XMLPrinter printer(nullptr, true);
  printer.OpenElement(kElement);
  printer.PushAttribute("link1", pair.first.c_str());
  printer.PushAttribute("link2", pair.second.c_str());
  printer.PushAttribute("reason", pair.reason.c_str());
  printer.CloseElement();
  std::string text = printer.CStr();
  while (!text.empty() && text.back() == '\n')  // depends on the version of tinyxml2
    text.pop_back();
  return text;
}

}  // namespace link_bounds
