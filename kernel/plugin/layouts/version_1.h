/* A copy of version 1 of the interface, for plug-ins as they were built before version 2. It does not change with
 * plugin.h. */
#include <stddef.h>
#include <stdint.h>

#define AXISCERT_CONTACT 0
#define AXISCERT_SEPARATED 1

typedef struct {
  size_t size;
  const void* coordinate[13];
} axiscert_batch;

typedef struct {
  uint8_t* verdict;
  uint16_t* comparisons;
  void* lhs[16];
  void* rhs[16];
  void* distance;
  void* closest_point[3];
  void* normal[3];
  uint8_t* feature;
} axiscert_answers;

typedef struct {
  double least_coordinate, greatest_coordinate, least_area, least_radius, greatest_radius;
} axiscert_limits;

typedef struct {
  uint32_t abi;
  uint32_t precision;
  const char* name;
  void (*run)(const axiscert_batch* batch, const axiscert_answers* answers);
  const char* summary;
  uint32_t exposes;
  uint32_t touching;
  const char* conforms_to;
  const char* formulae;
  axiscert_limits limits;
  const void* reserved[4];
} axiscert_kernel;

__attribute__((visibility("default"))) const axiscert_kernel* axiscert_plugin(uint32_t index);
