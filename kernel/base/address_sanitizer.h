// Defines AXISCERT_ADDRESS_SANITIZER where AddressSanitizer instruments this code; g++ and clang announce that
// differently.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define AXISCERT_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define AXISCERT_ADDRESS_SANITIZER
#endif
#endif
