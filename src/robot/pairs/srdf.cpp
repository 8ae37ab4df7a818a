// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Uses tinyxml2, which also escapes names.
#include "robot/pairs/srdf.h"

#include <tinyxml2.h>

#include <algorithm>
#include <set>
#include <utility>

namespace link_bounds {
namespace {

constexpr char kElement[] = "disable_collisions";
constexpr char kOfLink[] = "disable_default_collisions";
constexpr char kException[] = "enable_collisions";

/// Whether the element says which pairs need no check.
bool isOfPairs(const tinyxml2::XMLElement& element) {
  const std::string name = element.Name();
  return name == kElement || name == kOfLink || name == kException;
}

[[noreturn]] void refuse(const std::string& file, int line, const std::string& reason) {
  throw SrdfError("the SRDF \"" + file + "\"" +
                  (line > 0 ? ", line " + std::to_string(line) : std::string()) + ": " + reason);
}

/// Refuses a URDF, which has the same root, and misspelled elements, which would disable nothing.
void refuseOther(const tinyxml2::XMLElement& element, const std::string& file) {
  const std::string name = element.Name();
  const bool is_of_urdf = element.FirstChildElement("visual") ||
                          element.FirstChildElement("collision") ||
                          element.FirstChildElement("parent");
  if (is_of_urdf && (name == "link" || name == "joint")) {
    refuse(file, element.GetLineNum(),
           "it is a URDF, with a <" + name + "> that has a shape or a parent; give the SRDF");
  }
  if (!isOfPairs(element) && element.Attribute("link1") && element.Attribute("link2")) {
    refuse(file, element.GetLineNum(),
           "<" + name + "> is no element of a SRDF; write <disable_collisions>");
  }
}

std::string linkOf(const tinyxml2::XMLElement& element, const char* attribute, const Robot& robot,
                   const std::string& file) {
  const char* name = element.Attribute(attribute);
  if (!name) {
    refuse(file, element.GetLineNum(),
           std::string("<") + element.Name() + "> has no " + attribute + "; name a link there");
  }
  const auto is_it = [name](const Link& link) { return link.name == name; };
  if (std::none_of(robot.links.begin(), robot.links.end(), is_it)) {
    refuse(file, element.GetLineNum(),
           std::string("\"") + name + "\" is no link of the robot \"" + robot.name +
               "\"; give the SRDF of this robot, or correct the name");
  }
  return name;
}

/// The text as a comment. Two hyphens would end it, so a blank separates them.
std::string commentOf(std::string text) {
  for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos; ++at)
    text.insert(at + 1, " ");
  return " " + text + " ";
}

/// The XML nodes of a line. They belong to `document`.
std::vector<tinyxml2::XMLNode*> nodesOf(const SrdfLine& line, tinyxml2::XMLDocument& document) {
  std::vector<tinyxml2::XMLNode*> nodes;
  if (!line.comment.empty()) nodes.push_back(document.NewComment(commentOf(line.comment).c_str()));
  if (!line.pair) return nodes;
  tinyxml2::XMLElement* element = document.NewElement(kElement);
  element->SetAttribute("link1", line.pair->first.c_str());
  element->SetAttribute("link2", line.pair->second.c_str());
  if (!line.pair->reason.empty()) element->SetAttribute("reason", line.pair->reason.c_str());
  nodes.push_back(element);
  return nodes;
}

std::pair<std::string, std::string> sorted(const std::string& first, const std::string& second) {
  return first < second ? std::make_pair(first, second) : std::make_pair(second, first);
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
  if (const auto* const second = root->NextSiblingElement()) {
    refuse(file, second->GetLineNum(),
           std::string("a second root, <") + second->Name() +
               ">, is left out by all who read it; put its elements into the first");
  }
  std::vector<DisabledPair> pairs;
  std::set<std::pair<std::string, std::string>> enabled;
  std::vector<std::string> by_default;
  for (const auto* child = root->FirstChildElement(); child; child = child->NextSiblingElement()) {
    const std::string name = child->Name();
    if (name.rfind("xacro:", 0) == 0) {
      refuse(file, child->GetLineNum(),
             "it is a xacro file, with an element <" + name +
                 ">; expand it by xacro FILE > robot.srdf");
    }
    refuseOther(*child, file);
    if (name == kOfLink) by_default.push_back(linkOf(*child, "link", robot, file));
    if (name != kElement && name != kException) continue;
    const std::string first = linkOf(*child, "link1", robot, file);
    const std::string second = linkOf(*child, "link2", robot, file);
    const char* reason = child->Attribute("reason");
    if (name == kElement) pairs.push_back({first, second, reason ? reason : ""});
    if (name == kException) enabled.insert({{first, second}, {second, first}});
  }
  for (const std::string& link : by_default) {
    for (const Link& other : robot.links) {
      if (other.name != link && enabled.count({link, other.name}) == 0)
        pairs.push_back({link, other.name, kByDefault});
    }
  }
  return pairs;
}

std::string otherRobotWarning(const std::string& text, const Robot& robot,
                              const std::string& file) {
  tinyxml2::XMLDocument document;
  document.Parse(text.c_str(), text.size());
  const char* name = document.RootElement()->Attribute("name");
  if (!name || name == robot.name) return "";
  return "the SRDF \"" + file + "\" is that of a robot \"" + name + "\", the URDF that of \"" +
         robot.name + "\"; give the SRDF of this robot, or correct the name";
}

Exemptions::Exemptions(const std::vector<DisabledPair>& pairs) {
  for (const DisabledPair& pair : pairs) {
    const auto [entry, is_new] = reasons_.try_emplace(sorted(pair.first, pair.second), pair.reason);
    if (!is_new && pair.reason == kAlwaysReason) entry->second = kAlwaysReason;
  }
}

const std::string* Exemptions::reasonOf(const std::string& first, const std::string& second) const {
  const auto found = reasons_.find(sorted(first, second));
  return found == reasons_.end() ? nullptr : &found->second;
}

std::vector<DisabledPair> Exemptions::pairs() const {
  std::vector<DisabledPair> result;
  for (const auto& [names, reason] : reasons_)
    result.push_back({names.first, names.second, reason});
  return result;
}

std::string toSrdf(const SrdfLine& line) {
  tinyxml2::XMLDocument document;
  std::string text;
  for (tinyxml2::XMLNode* node : nodesOf(line, document)) {
    tinyxml2::XMLPrinter printer(nullptr, true);
    node->Accept(&printer);
    text += (text.empty() ? "" : "\n") + std::string(printer.CStr());
    while (text.back() == '\n')  // depends on the version of tinyxml2
      text.pop_back();
    document.DeleteNode(node);
  }
  return text;
}

std::string mergedSrdf(const std::string& text, const std::vector<SrdfLine>& lines) {
  tinyxml2::XMLDocument document;
  document.Parse(text.c_str(), text.size());
  tinyxml2::XMLElement* root = document.RootElement();
  std::vector<tinyxml2::XMLElement*> old;
  for (auto* child = root->FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (isOfPairs(*child)) old.push_back(child);
  }
  tinyxml2::XMLNode* last = old.empty() ? root->LastChild() : old.front()->PreviousSibling();
  for (const SrdfLine& line : lines) {
    for (tinyxml2::XMLNode* node : nodesOf(line, document))
      last = last ? root->InsertAfterChild(last, node) : root->InsertFirstChild(node);
  }
  for (tinyxml2::XMLElement* element : old)
    root->DeleteChild(element);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace link_bounds
