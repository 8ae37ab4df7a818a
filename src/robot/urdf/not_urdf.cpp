// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Mostly uses tinyxml2, which says why it refuses a text.
#include "robot/urdf/not_urdf.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cctype>

#include "robot/urdf/trimmed.h"
#include "robot/urdf/urdf_outline.h"

namespace link_bounds {
namespace {

/// PATH_MAX of Linux: no file name is longer.
constexpr std::size_t kMaxPath = 4096;

const std::string kExpand =
    "expand it, in a launch file by <param name=\"robot_description\" command=\"xacro FILE\"/>, "
    "on a command line by xacro FILE > robot.urdf";

bool isFileName(const std::string& text) {
  const auto has = [&text](const char* any) {
    return text.find_first_of(any) != std::string::npos;
  };
  if (text.size() > kMaxPath || has("<\n")) return false;
  return endsWith(text, ".urdf") || endsWith(text, ".xacro") || endsWith(text, ".xml") ||
         (has("/") && !has(" \t"));
}

std::string loadingOf(const std::string& file) {
  if (endsWith(file, ".xacro")) return kExpand;
  return "load the content, in a launch file by <param name=\"robot_description\" "
         "textfile=\"FILE\"/>, on a command line by rosparam set robot_description -t FILE";
}

/// Finds the first element that only xacro understands.
class XacroFinder : public tinyxml2::XMLVisitor {
 public:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute*) override {
    if (found_.empty() && std::string(element.Name()).rfind("xacro:", 0) == 0)
      found_ = element.Name();
    return found_.empty();
  }
  const std::string& found() const { return found_; }

 private:
  std::string found_;
};

/// The first element that only xacro understands; "" if there is none.
std::string xacroElementIn(const tinyxml2::XMLDocument& document) {
  XacroFinder finder;
  document.Accept(&finder);
  return finder.found();
}

/// Such as "line 3 (mismatched element)". `before` is the text before the first element, where
/// parsing began.
std::string placeOfError(const tinyxml2::XMLDocument& document, const std::string& before) {
  std::string name = document.ErrorName();
  const std::string prefix = "XML_ERROR_";
  if (name.compare(0, prefix.size(), prefix) == 0) name.erase(0, prefix.size());
  for (char& letter : name)
    letter = letter == '_' ? ' ' : static_cast<char>(std::tolower(letter));
  const auto lines_before = std::count(before.begin(), before.end(), '\n');
  return "line " + std::to_string(lines_before + document.ErrorLineNum()) + " (" + name + ")";
}

}  // namespace

std::string whyNoUrdf(const std::string& text) {
  const std::string name = trimmed(text);
  if (isFileName(name)) {
    return "it is the name of a file, \"" + name + "\", instead of its content; " + loadingOf(name);
  }
  const std::string elements = fromFirstElement(text);
  if (elements.empty()) return "it has no XML element; give the content of a URDF file";
  tinyxml2::XMLDocument document;
  document.Parse(elements.c_str());
  if (document.Error()) {
    return "it is not well-formed XML, see " +
           placeOfError(document, text.substr(0, text.size() - elements.size())) +
           "; correct it there";
  }
  const std::string xacro_element = xacroElementIn(document);
  if (!xacro_element.empty()) {
    return "it is a xacro file, with an element <" + xacro_element + ">; " + kExpand;
  }
  const tinyxml2::XMLElement* element = document.RootElement();
  const std::string root = element ? element->Name() : "";
  if (root != "robot") return "its root element is <" + root + ">, not <robot>; give a URDF";
  if (text.substr(0, text.size() - elements.size()).find("<!ENTITY") != text.npos)
    return "its <!DOCTYPE> has entities, which urdfdom does not read; write their values, and "
           "remove it";
  return "";
}

std::string secondRobotWarning(const std::string& text) {
  constexpr char kRobot[] = "robot";
  const std::string begin = std::string("<") + kRobot;
  if (text.find(begin) == text.rfind(begin)) return "";  // saves most robots the parsing
  tinyxml2::XMLDocument document;
  document.Parse(fromFirstElement(text).c_str());
  const tinyxml2::XMLElement* first = document.FirstChildElement(kRobot);
  if (!first) return "";
  const tinyxml2::XMLElement* second = first->NextSiblingElement(kRobot);
  if (!second) second = first->FirstChildElement(kRobot);
  if (!second) return "";
  const auto nameOf = [](const tinyxml2::XMLElement* robot) {
    const char* name = robot->Attribute("name");
    return std::string("\"") + (name ? name : "") + "\"";
  };
  return "the robot description has a second <robot>, " + nameOf(second) + " beside " +
         nameOf(first) + ", and all of it is left out; give one robot";
}

std::string xacroWarning(const std::string& text) {
  if (text.find("<xacro:") == std::string::npos) return "";  // saves most robots the parsing
  tinyxml2::XMLDocument document;
  document.Parse(fromFirstElement(text).c_str());
  const std::string element = xacroElementIn(document);
  if (element.empty()) return "";
  return "the robot description is a xacro file: <" + element +
         "> and all that it stands for is left out; " + kExpand;
}

}  // namespace link_bounds
