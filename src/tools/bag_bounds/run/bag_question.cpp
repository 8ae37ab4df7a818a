// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Standard input and pipes can be read only once, so texts are kept.
#include "tools/bag_bounds/run/bag_question.h"

#include <cstdint>
#include <set>

#include "geometry/distance/triangle_tree.h"
#include "link_bounds/robot/mesh/mesh_uri.h"
#include "packages/package_path.h"
#include "robot/mesh/mesh_files.h"
#include "tools/bag_bounds/run/fingerprint.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/robot_names.h"
#include "tools/command_line/terminal.h"
#include "tools/command_line/text_file.h"

namespace link_bounds {
namespace {

/// Throws UsageError if an output would overwrite one of the inputs.
void checkOutputs(const BagBoundsOptions& options, const std::vector<std::string>& inputs) {
  checkOutput("--out", options.out, inputs);
  checkOutput("--series", options.series, inputs);
}

const BagBoundsOptions& checkedOut(const BagBoundsOptions& options) {
  std::vector<std::string> inputs = options.bags;
  inputs.insert(inputs.end(), {options.urdf, options.zones, options.static_from});
  checkOutputs(options, inputs);
  if (!options.series.empty() && isSameFile(options.series, options.out))
    throw UsageError("--series is the file of --out; name another file");
  checkStandardInput({{"--urdf", options.urdf}, {"--zones", options.zones}});
  return options;
}

/// Whether the option is part of the fingerprint. The others change no line, or name files whose
/// content is part of it.
bool isCounted(const std::string& option_name) {
  static const std::set<std::string> kOthers{"each", "jobs",  "resume",     "allow-incomplete",
                                             "urdf", "zones", "static-from"};
  return kOthers.count(option_name) == 0;
}

/// A fingerprint of items of numbers that does not depend on their order.
template <class ItemAt>
std::string sumOf(std::size_t count, const ItemAt& itemAt) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto item = itemAt(i);
    Fingerprint numbers;
    numbers.add({reinterpret_cast<const char*>(&item), sizeof item});
    sum += numbers.value();
  }
  return std::to_string(sum);
}

}  // namespace

BagQuestion::BagQuestion(const BagBoundsOptions& options)
    : options_(checkedOut(options)),
      mesh_source_{rosPackages(), folderOf(options.urdf), progressBar(), {}, isInterrupted},
      zones_text_(options.zones.empty() ? "" : readText(options.zones, "zones")),
      zones_(options.zones.empty() ? std::vector<Zone>() : parseZones(zones_text_, options.zones)),
      urdf_(readText(options.urdf, "a URDF")),
      model_(std::make_shared<const Model>(makeModelOf(urdf_))) {
  mesh_source_.progress = nullptr;
}

Model BagQuestion::makeModelOf(const std::string& urdf) {
  Parameters parameters = options_.parameters;
  parameters.distance_limit = options_.distances.value_or(0);
  Model model = [&] {
    try {
      return makeModel(urdf, parameters, loader_, mesh_source_);
    } catch (const RobotError& error) {
      throw faultIn(options_.urdf, error);
    }
  }();
  if (model.links.empty())
    throw UsageError("no link of the robot has geometry of the kind " +
                     options_.parameters.geometry + "; choose another --geometry");
  for (const std::string& problem : model.problems)
    warn(problem);
  for (const std::string& warning : model.warnings)
    warn(warning);
  if (!model.left_out.empty()) say("note: " + model.left_out + "; --geometry both takes them, too");
  checkNames(*model.robot);
  checkOutputs(options_,
               meshFiles(*model.robot, mesh_source_.package_path, mesh_source_.base_folder));
  return model;
}

LoadedMesh BagQuestion::loadMesh(const std::string& uri) {
  return loader_.loadMeshes({uri}, mesh_source_).front();
}

LoadedTree BagQuestion::loadTree(const std::string& uri) {
  const auto found = trees_.find(uri);
  return found == trees_.end() ? loader_.loadTrees({uri}, mesh_source_).front() : found->second;
}

void BagQuestion::loadTrees() {
  std::vector<std::string> uris;
  for (const auto& [uri, points] : model_->mesh_uris)
    uris.push_back(uri);
  const std::vector<LoadedTree> trees = loader_.loadTrees(uris, mesh_source_);
  for (std::size_t i = 0; i < uris.size(); ++i)
    trees_[uris[i]] = trees[i];
}

/// Includes the loaded points and triangles, because a mesh file may refer to others, such as the
/// buffers of glTF.
std::string BagQuestion::fingerprint() const {
  Fingerprint result;
  const auto add_file = [&result](const std::string& file) {
    if (!result.addFile(file)) throw UsageError("cannot read " + file + " again");
  };
  result.add(LINK_BOUNDS_VERSION);
  result.add(urdf_);
  result.add(zones_text_);
  for (const auto& [uri, points] : model_->mesh_uris) {
    result.add(uri);
    add_file(resolveMeshUri(uri, mesh_source_.package_path, mesh_source_.base_folder).path);
    const std::vector<Eigen::Vector3d> kept = points->keptPoints();
    result.add(sumOf(kept.size(), [&](std::size_t i) -> Eigen::Vector3d { return kept[i]; }));
  }
  for (const auto& [uri, loaded] : trees_) {
    if (const auto& tree = loaded.triangles)
      result.add(sumOf(tree->triangles.size(), [&](std::size_t i) { return tree->corners(i); }));
  }
  for (const auto& [name, values] : options_.given) {
    if (!isCounted(name)) continue;
    result.add(name);
    for (const std::string& value : values)
      result.add(value);
  }
  if (!options_.static_from.empty()) add_file(options_.static_from);
  return result.text();
}

}  // namespace link_bounds
