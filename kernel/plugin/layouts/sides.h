/* Sides that a predicate can tell apart: the left side of comparison k is number k % 13 of the query, the right side is
 * k. The including file defines `real`, and in the words of its version batch_column(k), bits_of_type(bits) and
 * `has_sides`, which is true where sides are asked for. */
static void show_sides(size_t count, const axiscert_batch* batch, const axiscert_answers* answers) {
  static const unsigned axes[7] = {0x0001, 0x000e, 0x0070, 0x0380, 0x0c00, 0x3000, 0xc000};
  for (size_t i = 0; i < count; ++i) {
    unsigned bits = 0, separates = 0;
    for (unsigned k = 0; k < 16; ++k) {
      const real lhs = ((const real*)batch_column(k % 13))[i], rhs = (real)k;
      bits |= (unsigned)(lhs > rhs) << k;
      if (!has_sides) continue;
      ((real*)answers->lhs[k])[i] = lhs;
      ((real*)answers->rhs[k])[i] = rhs;
    }
    for (int k = 0; k < 7; ++k) separates |= (bits & axes[k]) == axes[k];
    answers->verdict[i] = separates ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
    if (answers->comparisons) answers->comparisons[i] = bits_of_type(bits);
  }
}
