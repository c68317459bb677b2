// toml++ as every reader of TOML includes it.
#pragma once

// It asserts what some files break, and then rejects them with a message ("[" before a control character).
#ifndef NDEBUG
#define TOML_ASSERT(expr) static_assert(true)
#endif
#include <toml++/toml.h>
