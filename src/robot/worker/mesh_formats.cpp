// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The format of a file: by its extension or, as assimp does for an unknown one, its content.
#include "robot/worker/mesh_formats.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "robot/worker/misread_formats.h"

namespace link_bounds {
namespace {

struct Format {
  const char* extension = nullptr;  ///< by which assimp knows its readers
  void (*check)(Lines&) = nullptr;
};

constexpr Format kStl{"stl", checkStl}, kObj{"obj", checkObj}, kPly{"ply", checkPly},
    kOff{"off", checkOff}, kCollada{"dae", checkCollada}, kGltf{"gltf", checkGltf};

constexpr std::pair<const char*, Format> kExtensions[] = {
    {".stl", kStl},     {".obj", kObj},   {".ply", kPly},  {".off", kOff},
    {".dae", kCollada}, {".gltf", kGltf}, {".glb", kGltf}, {".vrm", kGltf}};

/// Texts, in small letters, with which files begin; only blanks may stand before them.
constexpr std::pair<const char*, Format> kBeginnings[] = {
    {"solid", kStl}, {"off", kOff}, {"gltf", kGltf}, {"{", kGltf}};

[[noreturn]] void refuseFormat(const std::string& fault) {
  throw MeshError(fault + "; only STL, OBJ, PLY, OFF, Collada and glTF are read",
                  MeshFault::kFormat);
}

/// How many bytes are examined: more than assimp examines.
constexpr std::size_t kBeginning = 1 << 12;

/// The word is alone in its line: the header of a binary STL may begin with the same letters.
bool isPly(const std::string& beginning) {
  Words words(std::string_view(beginning).substr(0, beginning.find_first_of("\r\n")));
  return words.next() == "ply" && words.next().empty();
}

Format formatByContent(const std::string& beginning) {
  if (beginning.find("<collada") != beginning.npos) return kCollada;
  if (isPly(beginning)) return kPly;
  if (beginning.rfind("v ", 0) == 0 || beginning.find("\nv ") != beginning.npos) return kObj;
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  for (const auto& [word, format] : kBeginnings) {
    if (first != beginning.npos &&
        beginning.compare(first, std::string_view(word).size(), word) == 0)
      return format;
  }
  refuseFormat("its content does not tell its format");
}

/// Throws MeshError if it is none that is read.
Format formatOf(const Assimp::Importer& importer, Lines& lines, const std::string& path) {
  const std::string extension = inSmallLetters(std::filesystem::path(path).extension().string());
  for (const auto& [known, format] : kExtensions)
    if (extension == known) return format;
  if (extension != ".xml" && importer.IsExtensionSupported(extension))
    refuseFormat("it is not known what assimp leaves out of " + extension + " files");
  return formatByContent(inSmallLetters(lines.beginning(kBeginning)));
}

/// There are two readers of glTF.
void keepReaders(const char* extension, Assimp::Importer& importer) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    Words extensions(importer.GetImporterInfo(i)->mFileExtensions);
    std::string_view word = extensions.next();
    while (!word.empty() && word != extension)
      word = extensions.next();
    if (word.empty()) others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* const other : others) {
    importer.UnregisterLoader(other);
    delete other;
  }
}

}  // namespace

void checkFormat(Assimp::Importer& importer, ConfinedFiles& files, const std::string& path) {
  Lines lines(files, path);
  const Format format = formatOf(importer, lines, path);
  keepReaders(format.extension, importer);
  format.check(lines);
}

}  // namespace link_bounds
