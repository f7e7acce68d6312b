// Points of the RTL's source that vectors need not hit, each with its reason.
#pragma once

#include <string>
#include <vector>

#include "studies/vectors/code_points.h"

namespace pineda::vectors {

/// Points of one file that no legal input hits.
struct CodeWaiver {
  std::string place;  // "FILE:LINE", where it stands
  std::string file;   // in rtl/
  /// "KIND: TEXT": blocks of that kind that begin on a line with this text.
  std::vector<std::string> blocks;
  /// "NAME", with * for any characters: signals with all their bits; "NAME[9:4]": these of them.
  std::vector<std::string> bits;
  std::vector<std::string> designs;  // by name
  std::string reason;
};

/// Reads a file of tables [[waiver]].
///
/// Errors   Refused: not of that form, or a waiver without a reason.
std::vector<CodeWaiver> read_code_waivers(const std::string& file);

/// A point, and the waiver that excuses it where it is not hit.
struct JudgedPoint {
  CodePoint point;
  const CodeWaiver* waiver = nullptr;
};

/// The source of the RTL, line by line.
class RtlSource {
 public:
  explicit RtlSource(std::string package_text) : package_(std::move(package_text)) {}
  /// Without the blanks around it.
  const std::string& line(const std::string& file, int number);

 private:
  std::string package_;
  std::map<std::string, std::vector<std::string>> files_;
};

/// Puts the waivers of a design to the points. Those of files that have no points are left out.
///
/// Errors   Refused: a block, a bit or a name that waives nothing.
std::vector<JudgedPoint> judge_points(const std::vector<CodePoint>& points,
                                      const std::vector<CodeWaiver>& waivers,
                                      const std::string& design, RtlSource* source);

}  // namespace pineda::vectors
