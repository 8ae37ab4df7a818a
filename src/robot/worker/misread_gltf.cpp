// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// glTF, of which assimp leaves out members that it does not know.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "robot/worker/json_text.h"
#include "robot/worker/misread_formats.h"

namespace link_bounds {
namespace {

/// Extensions of glTF that assimp ignores, and without which vertices are missing or read wrongly:
/// other encodings of the data, and instances.
constexpr std::array<const char*, 4> kUnknownToAssimp{
    "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "EXT_meshopt_compression",
    "KHR_meshopt_compression"};

/// Prefixes of extensions that may be required, because they change no vertex or assimp knows them.
constexpr std::array<const char*, 11> kHarmless{
    "KHR_materials_",  "KHR_texture_",    "EXT_texture_", "MSFT_texture_",
    "KHR_lights_",     "EXT_lights_",     "KHR_xmp",      "KHR_draco_mesh_compression",
    "KHR_techniques_", "KHR_binary_glTF", "VRM"};

/// The componentType of a glTF that assimp reads as a position.
constexpr char kFloat[] = "5126";

/// The componentTypes that assimp reads as indices: unsigned integers of 8, 16 and 32 bits.
constexpr std::array kTypesOfIndices{"5121", "5123", "5125"};

/// Members that may be in objects that place geometry; "skeletons" by assimp's own exporter.
constexpr std::string_view kOfAll = " extensions extras name ";
constexpr std::string_view kOfNode =
    " camera children jointName matrix mesh rotation scale skeletons skin translation weights ";
constexpr std::string_view kOfScene = " nodes ";
constexpr std::string_view kOfMesh = " primitives weights ";
constexpr std::string_view kOfPrimitive = " attributes indices material mode targets ";
constexpr std::string_view kOfAccessor =
    " bufferView byteOffset componentType count max min normalized sparse type ";
constexpr std::string_view kOfView = " buffer byteLength byteOffset byteStride target ";

/// How many numbers a member of a node has.
constexpr std::pair<const char*, std::size_t> kNumbersOfNode[] = {
    {"matrix", 16}, {"rotation", 4}, {"scale", 3}, {"translation", 3}};

constexpr double kSizeOfPosition = 12;  // bytes

/// Refuses two members of one name, of which assimp reads only the first.
void refuseTwice(const Json& object, const std::string& what) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.members)
    if (!names.insert(name).second) throw MeshError(what + " has two members " + inQuotes(name));
}

/// `known` has names between blanks. `what` names the object in messages.
void checkMembers(const Json& object, std::string_view known, const std::string& what) {
  refuseTwice(object, what);
  for (const auto& [name, value] : object.members) {
    const std::string word = " " + name + " ";
    if (known.find(word) == known.npos && kOfAll.find(word) == kOfAll.npos)
      throw MeshError(what + " has the member " + inQuotes(name) + ", which glTF does not have");
  }
}

void checkAll(const Json& objects, std::string_view known, const std::string& what) {
  for (const auto& [number, object] : objects.members)
    checkMembers(object, known, what + " " + number);
}

void checkNode(const Json& node, const std::string& what) {
  for (const auto& [name, count] : kNumbersOfNode) {
    if (!node.has(name)) continue;
    const auto& numbers = node[name].members;
    const auto is_number = [](const auto& number) {
      return !number.second.is_string && isNumber(number.second.text);
    };
    if (numbers.size() != count || !std::all_of(numbers.begin(), numbers.end(), is_number))
      throw MeshError("the " + std::string(name) + " of " + what + " is not of " +
                      std::to_string(count) + " numbers");
  }
}

class Primitives {
 public:
  explicit Primitives(const Json& document) : document_(document) {}

  void check(const Json& primitive, const std::string& mesh) const {
    checkFloats(primitive, mesh);
    checkMembers(primitive, kOfPrimitive, "a primitive of " + mesh);
    checkPositions(primitive["attributes"]["POSITION"].text, mesh);
    if (primitive.has("indices")) checkIndices(primitive["indices"].text, mesh);
  }

  void checkFloats(const Json& primitive, const std::string& mesh) const {
    const Json& positions = at(document_["accessors"], primitive["attributes"]["POSITION"].text);
    if (!positions.members.empty() && positions["componentType"].text != kFloat)
      throw MeshError("positions of " + mesh +
                      " are no floats, which assimp misreads; store floats");
  }

 private:
  /// Looks where it is without a search: there may be a hundred thousand of them.
  static const Json& at(const Json& all, const std::string& name) {
    const std::size_t number = countOf(name);
    const bool is_at = number < all.members.size() && all.members[number].first == name;
    return is_at ? all.members[number].second : all[name];
  }

  void checkPositions(const std::string& name, const std::string& mesh) const {
    const Json& positions = at(document_["accessors"], name);
    if (positions.members.empty()) return;  // assimp refuses that
    if (positions["type"].text != "VEC3")
      throw MeshError("positions of " + mesh + " are of the type " +
                      inQuotes(positions["type"].text) + ", not VEC3");
    const std::string& stride =
        at(document_["bufferViews"], positions["bufferView"].text)["byteStride"].text;
    const double bytes = std::strtod(stride.c_str(), nullptr);
    if (bytes != 0 && !(bytes >= kSizeOfPosition))
      throw MeshError("positions of " + mesh + " have a byteStride below 12");
  }

  void checkIndices(const std::string& name, const std::string& mesh) const {
    const Json& indices = at(document_["accessors"], name);
    if (indices.members.empty()) return;  // assimp refuses that
    const std::string& component = indices["componentType"].text;
    const auto& types = kTypesOfIndices;
    if (std::find(types.begin(), types.end(), component) == types.end() ||
        indices["type"].text != "SCALAR")
      throw MeshError("indices of " + mesh + " are no unsigned integers");
  }

  const Json& document_;
};

[[noreturn]] void refuseExtension(const std::string& name) {
  throw MeshError("it uses the extension " + name +
                  ", which assimp does not know; export it without");
}

/// The name of an extension that is used is the name of a member or a string.
void refuseUnknown(const Json& value) {
  for (const char* const unknown : kUnknownToAssimp)
    if (value.text == unknown) refuseExtension(unknown);
  for (const auto& [name, member] : value.members) {
    for (const char* const unknown : kUnknownToAssimp)
      if (name == unknown) refuseExtension(unknown);
    refuseUnknown(member);
  }
}

bool isHarmless(const std::string& extension) {
  return std::any_of(kHarmless.begin(), kHarmless.end(),
                     [&](const char* beginning) { return extension.rfind(beginning, 0) == 0; });
}

/// The JSON of a file. In a binary file, its size stands before it.
std::string_view jsonOf(const std::string& file) {
  constexpr std::size_t kAtSize = 12, kBegin = 20;
  const std::string_view text = file;
  if (text.substr(0, 4) != "glTF" || text.size() < kBegin) return text;
  std::uint32_t size = 0;
  std::memcpy(&size, file.data() + kAtSize, sizeof(size));
  return text.substr(kBegin, size);
}

}  // namespace

void checkGltf(Lines& lines) {
  const std::string file = lines.all();
  const Json document = parseJson(jsonOf(file));
  refuseUnknown(document);
  for (const auto& [number, name] : document["extensionsRequired"].members) {
    if (!isHarmless(name.text)) refuseExtension(name.text);
  }
  const Primitives primitives(document);
  const bool is_first_version = document["asset"]["version"].text.substr(0, 1) == "1";
  for (const auto& [number, mesh] : document["meshes"].members) {
    for (const auto& [part, primitive] : mesh["primitives"].members) {
      if (is_first_version) {
        primitives.checkFloats(primitive, "mesh " + number);
      } else {
        primitives.check(primitive, "mesh " + number);
      }
    }
  }
  if (is_first_version) return;  // its objects have other members
  refuseTwice(document, "its JSON");
  checkAll(document["scenes"], kOfScene, "scene");
  checkAll(document["nodes"], kOfNode, "node");
  checkAll(document["accessors"], kOfAccessor, "accessor");
  checkAll(document["bufferViews"], kOfView, "bufferView");
  checkAll(document["meshes"], kOfMesh, "mesh");
  for (const auto& [number, node] : document["nodes"].members)
    checkNode(node, "node " + number);
}

}  // namespace link_bounds
