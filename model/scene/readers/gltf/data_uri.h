// URIs in glTF: percent encoding, and data URIs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pineda::scene {

/// Decodes percent encoding: "%20" becomes a blank. A '%' without two hexadecimal digits after it
/// stays as it is.
std::string percent_decoded(std::string_view text);

/// Decodes a data URI; its media type is ignored.
///
/// In       "data:[media type][;base64],DATA"; scheme and ";base64" in upper or lower case.
/// Out      false: `uri` is no data URI. *bytes has no value if DATA is not valid base64: an
///          invalid digit, or a number of digits that cannot occur. Padding may be left out.
/// Source   RFC 2397; RFC 4648, 4.
bool read_data_uri(std::string_view uri, std::optional<std::string>* bytes);

}  // namespace pineda::scene
