// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Text files: words and numbers.
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include "block_mutation.h"
#include "mutation.h"

namespace link_bounds {
namespace {

using brute_force::Random;

/// The offset of a token and its length.
using Token = std::pair<std::size_t, std::size_t>;

constexpr char kSeparators[] = " \t\r\n<>='\"/,:;()[]{}";
constexpr double kShareOfAllNumbers = 0.3;
constexpr double kShareOfOddNumbers = 0.2;

std::vector<Token> tokensOf(const std::string& text) {
  std::vector<Token> tokens;
  std::size_t begin = text.find_first_not_of(kSeparators);
  while (begin != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, begin), text.size());
    tokens.emplace_back(begin, end - begin);
    begin = text.find_first_not_of(kSeparators, end);
  }
  return tokens;
}

bool isNumber(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size();
}

std::vector<Token> numbersOf(const std::string& text) {
  std::vector<Token> tokens = tokensOf(text);
  const auto is_word = [&](const Token& t) { return !isNumber(text.substr(t.first, t.second)); };
  tokens.erase(std::remove_if(tokens.begin(), tokens.end(), is_word), tokens.end());
  return tokens;
}

/// All numbers, or only those with a point, which are mostly coordinates.
std::vector<Token> someNumbersOf(const std::string& text, Random& random) {
  std::vector<Token> numbers = numbersOf(text);
  if (random.uniform(0, 1) < kShareOfAllNumbers) return numbers;
  const auto is_whole = [&](const Token& t) {
    return text.substr(t.first, t.second).find('.') == std::string::npos;
  };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), is_whole), numbers.end());
  return numbers;
}

std::string swapTwo(std::string text, const std::vector<Token>& tokens, Random& random) {
  if (tokens.size() < 2) return text;
  Token first = tokens[below(tokens.size(), random)];
  Token second = tokens[below(tokens.size(), random)];
  if (first.first == second.first) return text;
  if (second < first) std::swap(first, second);
  const std::string late = text.substr(second.first, second.second);
  text.replace(second.first, second.second, text.substr(first.first, first.second));
  text.replace(first.first, first.second, late);
  return text;
}

std::string swapTokens(std::string text, Random& random) {
  const std::vector<Token> tokens = tokensOf(text);
  return swapTwo(std::move(text), tokens, random);
}

std::string swapNumbers(std::string text, Random& random) {
  const std::vector<Token> tokens = someNumbersOf(text, random);
  return swapTwo(std::move(text), tokens, random);
}

std::string numberFor(const std::string& old, Random& random) {
  static const std::vector<std::string> kOdd{
      "0",     "-1",   "1",        "7",     "nan",  "inf",        "-inf",
      "1e999", "1e38", "1e39",     "1e-46", "255",  "2147483648", "4294967295",
      "-0.0",  "",     "0x7fffff", "1,5",   "99999"};
  if (random.uniform(0, 1) < kShareOfOddNumbers) return kOdd[below(kOdd.size(), random)];
  return std::to_string(std::strtod(old.c_str(), nullptr) +
                        random.sign() * random.magnitude(-1, 3));
}

std::string changeNumber(std::string text, Random& random) {
  const std::vector<Token> numbers = someNumbersOf(text, random);
  if (numbers.empty()) return text;
  const auto [begin, size] = numbers[below(numbers.size(), random)];
  return text.replace(begin, size, numberFor(text.substr(begin, size), random));
}

/// Replaces a token by another one of the text.
std::string replaceToken(std::string text, Random& random) {
  const std::vector<Token> tokens = tokensOf(text);
  if (tokens.empty()) return text;
  const Token from = tokens[below(tokens.size(), random)];
  const Token to = tokens[below(tokens.size(), random)];
  return text.replace(to.first, to.second, text.substr(from.first, from.second));
}

}  // namespace

std::string mutatedText(const std::string& text, Random& random) {
  using Mutator = std::string (*)(std::string, Random&);
  static constexpr Mutator kMutators[] = {hitBytes,     swapTokens,   swapNumbers,    swapNumbers,
                                          changeNumber, changeNumber, changeNumber,   changeNumber,
                                          changeNumber, replaceToken, duplicateBlock, deleteBlock,
                                          cutShort};
  return kMutators[below(std::size(kMutators), random)](text, random);
}

}  // namespace link_bounds
