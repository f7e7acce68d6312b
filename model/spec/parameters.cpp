#include "model/spec/parameters.h"

#include <fmt/format.h>

#include <cmath>

namespace pineda::spec {
namespace {

const Number* number_of(const Parameter& p) { return std::get_if<Number>(&p.member); }

/// A member's value in the key's unit, also for values out of range.
double in_key_unit(const Number& number, int member) {
  return number.is_log2 ? std::exp2(member) : member;
}

std::string end_text(const Number& number, const Limit& end) {
  return end.is_number() ? fmt::format("{}", in_key_unit(number, end.number)) : end.text;
}

std::string range_reason(const Parameter& p, const Design& d) {
  const Number* number = number_of(p);
  if (number == nullptr || !p.used(d)) return {};
  const int value = d.*number->member;
  const int low = number->low(d);
  const int high = number->high(d);
  if (value >= low && value <= high) return {};
  return fmt::format("{} is {}, must be {} to {}", p.key, in_key_unit(*number, value),
                     in_key_unit(*number, low), in_key_unit(*number, high));
}

/// Reads the value of a member of each type.
struct Read {
  const Design& design;

  using Value = std::variant<bool, int, std::string>;
  Value operator()(const Number& number) const {
    const int value = design.*number.member;
    return number.is_log2 ? 1 << std::clamp(value, 0, 30) : value;
  }
  Value operator()(bool Design::*member) const { return design.*member; }
  template <class Choice>
  Value operator()(Choice Design::*member) const {
    return std::string(name_of(design.*member));
  }
};

struct Range {
  std::string operator()(const Number& number) const {
    return end_text(number, number.low) + " to " + end_text(number, number.high);
  }
  std::string operator()(bool Design::*) const { return "true, false"; }
  template <class Choice>
  std::string operator()(Choice Design::*) const {
    return words_of<Choice>();
  }
};

struct Written {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(int value) const { return std::to_string(value); }
  std::string operator()(const std::string& word) const { return '\'' + word + '\''; }
};

}  // namespace

const Parameter& parameter(const std::string& key) {
  for (const Parameter& p : kParameters) {
    if (key == p.key) return p;
  }
  throw std::out_of_range("no parameter " + key);
}

const Parameter& parameter(int Design::*member) {
  for (const Parameter& p : kParameters) {
    const Number* number = number_of(p);
    if (number != nullptr && number->member == member) return p;
  }
  throw std::out_of_range("no parameter has this member");
}

bool is_listed(const Parameter& p, const Design& d) {
  return p.listed != nullptr ? p.listed(d) : p.used(d);
}

std::variant<bool, int, std::string> value_of(const Parameter& p, const Design& d) {
  return std::visit(Read{d}, p.member);
}

std::string file_value(const Parameter& p, const Design& d) {
  return std::visit(Written(), value_of(p, d));
}

std::string range_text(const Parameter& p) { return std::visit(Range(), p.member); }

std::string range_reason(const Design& d) {
  int last_round = 0;
  for (const Parameter& p : kParameters) last_round = std::max(last_round, p.round);
  for (int round = 0; round <= last_round; ++round) {
    for (const Parameter& p : kParameters) {
      if (p.round != round) continue;
      if (const std::string reason = range_reason(p, d); !reason.empty()) return reason;
    }
  }
  return {};
}

}  // namespace pineda::spec
