// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which check a file needs: by its extension or, as assimp does for an unknown one, its content.
#include "robot/worker/misread_files.h"

#include <assimp/Importer.hpp>
#include <filesystem>
#include <utility>

#include "robot/worker/misread_formats.h"

namespace link_bounds {
namespace {

using Check = void (*)(Lines&);

/// How a file is checked, or why no file of its format is read.
struct Rule {
  Check check = nullptr;
  const char* refusal = nullptr;
};

constexpr Rule kDirectX{nullptr,
                        "assimp does not check the indices of DirectX files; store it as STL"};
constexpr Rule kOgre{nullptr, "assimp does not check the indices of Ogre's files; store it as STL"};
constexpr Rule k3mf{
    nullptr, "assimp does not check the numbers and references of 3MF files; store it as STL"};
constexpr Rule kAmf{nullptr, "assimp leaves out volumes and turns of AMF files; store it as STL"};
constexpr Rule kNff{nullptr, "assimp leaves out lines of NFF files; store it as STL"};
constexpr Rule kArchive{nullptr, "it is an archive; unpack it, and name the mesh in it"};

constexpr std::pair<const char*, Rule> kExtensions[] = {
    {".stl", {checkStl}},   {".obj", {checkObj}},   {".ply", {checkPly}},     {".off", {checkOff}},
    {".gltf", {checkGltf}}, {".glb", {checkGltf}},  {".vrm", {checkGltf}},    {".ac", {checkAc3d}},
    {".acc", {checkAc3d}},  {".ac3d", {checkAc3d}}, {".ase", {checkAse}},     {".ask", {checkAse}},
    {".dxf", {checkDxf}},   {".raw", {checkRaw}},   {".dae", {checkCollada}}, {".zae", kArchive},
    {".x", kDirectX},       {".mesh", kOgre},       {".3mf", k3mf},           {".amf", kAmf},
    {".nff", kNff},         {".enff", kNff}};

/// Texts, in small letters, with which files begin; only blanks may stand before them.
constexpr std::pair<const char*, Rule> kBeginnings[] = {
    {"solid", {checkStl}}, {"off", {checkOff}},     {"gltf", {checkGltf}},
    {"{", {checkGltf}},    {"ac3d", {checkAc3d}},   {"*3dsmax", {checkAse}},
    {"xof ", kDirectX},    {"pk\x03\x04", kArchive}};

/// Elements of XML, in small letters, by which a format is known. AMF has a <mesh>, too.
constexpr std::pair<const char*, Rule> kElements[] = {{"<collada", {checkCollada}},
                                                      {"<amf", kAmf},
                                                      {"<mesh>", kOgre},
                                                      {"<submesh", kOgre},
                                                      {"<sharedgeometry", kOgre}};

/// How many bytes are examined: more than assimp examines.
constexpr std::size_t kBeginning = 1 << 12;

/// The word is alone in its line: the header of a binary STL may begin with the same letters.
bool isPly(const std::string& beginning) {
  Words words(std::string_view(beginning).substr(0, beginning.find_first_of("\r\n")));
  return words.next() == "ply" && words.next().empty();
}

Rule ruleByContent(std::string beginning) {
  const std::string text = inSmallLetters(std::move(beginning));
  for (const auto& [element, rule] : kElements)
    if (text.find(element) != text.npos) return rule;
  if (isPly(text)) return {checkPly};
  if (text.rfind("v ", 0) == 0 || text.find("\nv ") != text.npos) return {checkObj};
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  for (const auto& [word, rule] : kBeginnings) {
    if (first != text.npos && text.compare(first, std::string(word).size(), word) == 0) return rule;
  }
  return {};
}

/// An unknown format has no rule: assimp refuses what it does not know.
Rule ruleOf(Lines& lines, const std::string& path) {
  const std::string extension = inSmallLetters(std::filesystem::path(path).extension().string());
  for (const auto& [known, rule] : kExtensions)
    if (extension == known) return rule;
  const bool is_known = extension != ".xml" && Assimp::Importer().IsExtensionSupported(extension);
  return is_known ? Rule() : ruleByContent(lines.beginning(kBeginning));
}

}  // namespace

void refuseMisread(ConfinedFiles& files, const std::string& path) {
  Lines lines(files, path);
  const Rule rule = ruleOf(lines, path);
  if (rule.refusal) throw MeshError(rule.refusal);
  if (rule.check) rule.check(lines);
}

}  // namespace link_bounds
