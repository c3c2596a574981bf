/* A plug-in of version 2 of the interface, of which nothing but its number may be read: the page ends after it. */
#define ABI 2
#include "kernel/plugin/declarations/number_alone.h"
