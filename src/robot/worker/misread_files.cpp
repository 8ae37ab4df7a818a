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

[[noreturn]] void refuseX(Lines&) {
  throw MeshError("assimp does not check the indices of DirectX files; store it as STL");
}

[[noreturn]] void refuseOgre(Lines&) {
  throw MeshError("assimp does not check the indices of Ogre's XML; store it as STL");
}

[[noreturn]] void refuse3mf(Lines&) {
  throw MeshError("assimp does not check the numbers and references of 3MF files; store it as STL");
}

[[noreturn]] void refuseAmf(Lines&) {
  throw MeshError("assimp leaves out volumes and turns of AMF files; store it as STL");
}

[[noreturn]] void refuseNff(Lines&) {
  throw MeshError("assimp leaves out lines of NFF files; store it as STL");
}

[[noreturn]] void refuseArchive(Lines&) {
  throw MeshError("it is an archive; unpack it, and name the mesh in it");
}

constexpr std::pair<const char*, Check> kExtensions[] = {
    {".stl", checkStl},     {".obj", checkObj},      {".ply", checkPly},   {".off", checkOff},
    {".dae", checkCollada}, {".zae", refuseArchive}, {".gltf", checkGltf}, {".glb", checkGltf},
    {".vrm", checkGltf},    {".ac", checkAc3d},      {".acc", checkAc3d},  {".ac3d", checkAc3d},
    {".ase", checkAse},     {".ask", checkAse},      {".dxf", checkDxf},   {".raw", checkRaw},
    {".x", refuseX},        {".3mf", refuse3mf},     {".amf", refuseAmf},  {".nff", refuseNff},
    {".enff", refuseNff}};

/// Texts, in small letters, with which files begin; only blanks may stand before them.
constexpr std::pair<const char*, Check> kBeginnings[] = {
    {"solid", checkStl}, {"off", checkOff}, {"gltf", checkGltf},   {"{", checkGltf},
    {"ac3d", checkAc3d}, {"xof ", refuseX}, {"*3dsmax", checkAse}, {"pk\x03\x04", refuseArchive}};

/// How many bytes are examined: more than assimp examines.
constexpr std::size_t kBeginning = 1 << 12;

/// The word is alone in its line: the header of a binary STL may begin with the same letters.
bool isPly(const std::string& beginning) {
  Words words(std::string_view(beginning).substr(0, beginning.find_first_of("\r\n")));
  return words.next() == "ply" && words.next().empty();
}

Check checkByContent(std::string beginning) {
  const std::string text = inSmallLetters(std::move(beginning));
  if (text.find("<collada") != text.npos) return checkCollada;
  if (text.find("<mesh>") != text.npos || text.find("<submesh") != text.npos ||
      text.find("<sharedgeometry") != text.npos)
    return refuseOgre;
  if (isPly(text)) return checkPly;
  if (text.rfind("v ", 0) == 0 || text.find("\nv ") != text.npos) return checkObj;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  for (const auto& [word, check] : kBeginnings) {
    if (first != text.npos && text.compare(first, std::string(word).size(), word) == 0)
      return check;
  }
  return nullptr;
}

}  // namespace

void refuseMisread(ConfinedFiles& files, const std::string& path) {
  Lines lines(files, path);
  const std::string extension = inSmallLetters(std::filesystem::path(path).extension().string());
  for (const auto& [known, check] : kExtensions)
    if (extension == known) return check(lines);
  const bool is_known = extension != ".xml" && Assimp::Importer().IsExtensionSupported(extension);
  if (is_known) return;
  if (const Check check = checkByContent(lines.beginning(kBeginning))) check(lines);
}

}  // namespace link_bounds
