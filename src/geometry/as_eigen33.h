// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Part of a class of Eigen in our own builds: a range-for over a vector does not compile.
// No #pragma once, because Eigen includes it in two classes.
void begin() const = delete;
void end() const = delete;
