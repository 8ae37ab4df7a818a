// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The loader thread waits while the update thread adopts.
#include "node/loading/model_hand_over.h"

#include <utility>

#include "world/log/guarded.h"

namespace link_bounds {

bool ModelHandOver::give(ModelPtr model) {
  return loader_.await(queue_, [this, owned = loader_.owned(std::move(model))] {
    adopt(owned);
    return true;
  });
}

void ModelHandOver::adopt(const ModelPtr& model) {
  try {
    adopt_(model);
    in_use_ = model;
  } catch (...) {
    if (in_use_) guarded([this] { adopt_(in_use_); });
    throw;
  }
}

}  // namespace link_bounds
