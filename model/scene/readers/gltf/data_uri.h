// Uniform resource identifiers as glTF uses them: data in the text, or a path.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pineda::scene {

/// "%20" becomes a blank; a '%' that no two hexadecimal digits follow stays.
std::string percent_decoded(std::string_view text);

/// What a data URI holds, whatever its media type says.
///
/// In       "data:[media type][;base64],DATA"; scheme and ";base64" in any case.
/// Out      false: `uri` is no data URI. *bytes has no value where DATA is no base64: a digit that
///          there is not, or a length that no bytes have. Padding may be left out.
/// Source   RFC 2397; RFC 4648, 4.
bool read_data_uri(std::string_view uri, std::optional<std::string>* bytes);

}  // namespace pineda::scene
