// What text from outside may hold: UTF-8 without control characters, so that it can be logged, stored and shown as it is.
#pragma once

#include <string>
#include <string_view>

namespace foothold::server {

// True for valid UTF-8 (RFC 3629: no overlong forms, no surrogates) without control characters (U+0000 to U+001F, U+007F to
// U+009F).
bool is_clean_text(std::string_view text);

// True for 64 lower-case hexadecimal digits.
bool is_sha256_hex(std::string_view text);

// `text` with what is not clean written as \xNN, for text that has to be passed on whatever it holds. Clean text is unchanged.
std::string cleaned(std::string_view text);

// `text` in single quotes for a message, with what is not clean written as \xNN and cut after 80 octets ("... (1000 octets)").
std::string quoted(std::string_view text);

}  // namespace foothold::server
