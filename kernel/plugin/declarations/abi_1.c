/* A plug-in of version 1 of the interface, of which nothing but its number may be read: the page ends after it. */
#define ABI 1
#include "kernel/plugin/declarations/number_alone.h"
