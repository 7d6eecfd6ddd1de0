// What every error number of foothold.idl means: name, stage, hint, whether trying again can help.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace foothold::msg {

struct ErrorKind {
  std::uint16_t code;
  std::string_view name;   // the constant's name in foothold.idl
  std::string_view stage;  // server, request, scene, search, check, worker
  std::string_view hint;   // what to do next
  bool retryable;
};

// All of them, by code. A test holds this table against foothold.idl.
std::span<const ErrorKind> error_kinds();

// An error of a known code with its name, stage, hint and retryable filled in. `field` is a path or empty.
Error make_error(std::uint16_t code, std::string message, std::string field = {});

std::string_view state_name(State state);
// SUCCEEDED, PARTIAL, FAILED, CANCELLED, EXPIRED, CRASHED or REJECTED.
bool is_final(State state);

}  // namespace foothold::msg
