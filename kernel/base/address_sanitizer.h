// Whether AddressSanitizer instruments this code, which g++ and clang say each in their own way.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define AXISCERT_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define AXISCERT_ADDRESS_SANITIZER
#endif
#endif
