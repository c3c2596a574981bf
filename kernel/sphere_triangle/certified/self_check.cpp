#include "kernel/sphere_triangle/certified/steps.h"

#include <iterator>
#include <limits>

#include "kernel/sphere_triangle/names.h"

namespace axiscert::certified {
namespace {

using enum Verdict;

// ax ay az bx by bz cx cy cz px py pz r, and the exact answer of the closed and the open sphere and that of the
// conservative test, which has every bit of its own.
template <class Real>
struct StoredAnswer {
  Real query[13];
  Verdict closed, open, conservative;
};

// clang-format off
// Some of 10^5 queries near contact, or at a change of the conservative answer, of which some answer was another in a
// library that was compiled with -ffast-math, -fassociative-math or -ffp-contract=fast, or called with subnormal
// numbers flushed to zero or another rounding direction. Then inputs that are no queries, and in binary64 one that
// scaling would lose a bit of.
constexpr StoredAnswer<float> stored_floats[] = {
    {{0, 0, 0, 0x1.2c634p+18f, 0, 0x1.26e46p+19f, 0, 0x1.9bb56p+19f, 0x1.3fceep+19f, 0x1.150ccp+18f,
      0x1.5a44p+15f, 0x1.20cacp+19f, 0x1.d085acp-40f}, contact, contact, contact},
    {{0, 0, 0, 0x1.2594ep+19f, 0, 0x1.341f8p+17f, 0, 0x1.1f42ep+19f, 0x1.e4a1cp+18f, 0x1.ecabp+17f, 0x1.26dap+16f,
      0x1.fb41p+16f, 0x1.2a2f3cp-39f}, separated, separated, contact},
    {{0x1p-148f, 0x1p-147f, 0x1p-147f, 0, 0x1p-148f, 0x1p-147f, -0x1p-148f, -0x1p-147f, 0x1p-147f, -0x1p-147f,
      -0x1p-147f, -0x1p-148f, 0x1p-147f}, separated, separated, separated},
    {{0, 0x1.8p-147f, 0x1.8p-147f, -0x1p-147f, -0x1p-148f, 0x1p-148f, -0x1p-147f, -0x1p-148f, 0x1p-148f, 0,
      0x1p-148f, -0x1p-148f, 0}, separated, separated, separated},
    {{-0x1.8p+8f, 0x1.4p+9f, -0x1.4p+9f, -0x1.8p+8f, -0x1.4p+9f, -0x1.8p-148f, 0, 0x1.4p+9f, -0x1.4p+9f,
      -0x1.8p+7f, 0x1.4p+8f, -0x1.ep+8f, 0}, separated, separated, contact},
    {{0x1.2bp+5f, 0x1p-149f, 0, 0x1.7cp+4f, -0x1p+12f, 0, 0x1.7cp+4f, 0x1.8p+13f, 0, 0x1p-149f, 0x1p-149f, 0,
      0x1.7cp+4f}, contact, contact, contact},
    {{0x1.8p-4f, -0x1.8p-5f, -0x1p-6f, -0x1.cp-4f, -0x1p-4f, 0x1p-149f, 0x1.4p-4f, 0x1.8p-4f, 0x1.8p-5f,
      0x1.4p-5f, -0x1p-6f, 0x1p-8f, 0}, separated, separated, contact},
    {{-0x1.cp+4f, -0x1.8p+5f, 0x1p+4f, 0x1.ep+5f, -0x1.cp+3f, -0x1.8p-148f, 0x1p+5f, 0x1.6p+4f, 0x1.2p+5f,
      0x1.fp+4f, -0x1.bp+3f, 0x1.ap+3f, 0}, separated, separated, contact},
    {{0x1.9p+15f, -0x1.8p+12f, -0x1p+12f, -0x1.cp+14f, 0x1p-149f, 0x1.cp+13f, 0x1.ep+14f, -0x1.bp+15f, -0x1p+11f,
      0x1.8p+12f, -0x1.ep+13f, 0x1.6p+12f, 0}, separated, separated, contact},
    {{0, 0x1.2e3p+6f, -0x1.3p+2f, 0, 0x1.2e3p+6f, 0x1.a8p+2f, 0, 0x1.616p+6f, 0, 0, 0x1p-149f, -0x1.8p-148f,
      0x1.2e3p+6f}, contact, contact, contact},
    {{-0x1.d46224p-1f, 0x1.a6faap-2f, -0x1.cf7856p-1f, 0x1.6b863ap-2f, 0x1.09b6d4p-3f, 0x1.720276p-1f,
      -0x1.c1c744p-1f, 0x1.dbd0dep-3f, 0x1.2c7accp-1f, -0x1.f4b694p-2f, 0x1.3091dcp-1f, -0x1.729128p-1f,
      0x1.4cabbap-2f}, separated, separated, contact},
    {{0x1.eee7e6p-4f, -0x1.71ed06p-1f, 0x1.a736bap-3f, 0x1.6f90fep-1f, 0x1.9b1152p-3f, -0x1.fbd682p-2f,
      -0x1.14f218p-1f, -0x1.33e9b4p-3f, 0x1.1f7aa4p-3f, 0x1.b7ef74p-1f, -0x1.6270bap-2f, -0x1.e68786p-2f,
      0x1.d34cd6p-2f}, separated, separated, contact},
    {{0x1.191852p-1f, 0x1.f8487ep-2f, -0x1.f49b2cp-2f, 0x1.195d4p-4f, -0x1.3486p-1f, -0x1.efcfb2p-1f,
      -0x1.b317ccp-1f, -0x1.4c7ae2p-3f, 0x1.9cffe6p-1f, 0x1.81de26p-1f, -0x1.16f49ap-1f, 0x1.2dd57ap-1f,
      0x1.366b5p+0f}, separated, separated, separated},
    {{-0x1.0624dep-30f, 0x1.0624dep-30f, -0x1.89374cp-29f, -0x1.0624dep-30f, 0x1.0624dep-30f, -0x1.89374cp-29f,
      0x1.0624dep-29f, -0x1.0624dep-30f, 0x1.0624dep-30f, -0x1p-19f, -0x1.8p-19f, 0x1.8p-19f, 0x1.2c28aap-18f},
      separated, separated, contact},
    {{-0x1.38b65cp-13f, -0x1.0c4336p-14f, 0x1.6c1968p-13f, -0x1.0634d4p-12f, -0x1.9880f2p-11f, 0x1.3b5ad4p-11f,
      0x1.78564p-12f, 0x1.9b8f32p-11f, -0x1.cb5f4p-11f, -0x1.0469dep-3f, 0x1.7c185ap-1f, 0x1.fac128p-1f,
      0x1.3e5e5ep+0f}, separated, separated, contact},
    {{0x1.aac7aep-1f, -0x1.dbf53p-4f, 0x1.f6fa2cp-1f, -0x1.2a32e4p-5f, 0x1.9e0618p-1f, 0x1.8d5f4ep-1f,
      -0x1.49f64cp-1f, 0x1.cf68eap-2f, -0x1.c2606ap-3f, 0x1.7cd3bcp-4f, 0x1.8df1b8p-1f, -0x1.e936b6p-1f,
      0x1.1748e2p+0f}, separated, separated, contact},
    {{-0x1.0dddeap-3f, -0x1.cd817p-1f, -0x1.bd6b86p-5f, -0x1.cbd5fp-1f, -0x1.45438ap-4f, 0x1.7f870ep-2f,
      -0x1.ef1b34p-2f, 0x1.f06358p-3f, -0x1.82bd2cp-3f, -0x1.e65dap-4f, -0x1.60bda6p-2f, -0x1.f9b464p-3f,
      0x1.c33336p-3f}, separated, separated, separated},
    {{0x1.335d1p-2f, -0x1.4e7526p-3f, 0x1.5cc042p-1f, -0x1.abcdd6p-2f, 0x1.ca625cp-2f, -0x1.6d3be2p-1f,
      0x1.7d9fecp-2f, 0x1.e09a2ep-1f, 0x1.03ba0cp-4f, 0x1.a712fp-5f, 0x1.07c312p-1f, -0x1.6d38c4p-5f, 0x1.12a2e8p-5f},
      separated, separated, contact},
    {{1, 0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0, 1}, invalid, invalid, invalid},
    {{1, 0, 0, 0, std::numeric_limits<float>::infinity(), 0, 0, 0, 1, 0, 0, 0, 1}, invalid, invalid, invalid},
    {{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1}, invalid, invalid, invalid},
};
constexpr StoredAnswer<double> stored_doubles[] = {
    {{0x0.0000000000006p-1022, -0x0.0000000000002p-1022, -0x0.0000000000006p-1022, 0x0.0000000000006p-1022,
      -0x0.0000000000002p-1022, -0x0.0000000000006p-1022, -0x0.0000000000004p-1022, 0x0.0000000000004p-1022,
      0x0.0000000000006p-1022, 0, 0x0.0000000000006p-1022, 0, 0x0.0000000000002p-1022}, separated, separated,
      separated},
    {{0x0.0000000000002p-1022, 0x0.0000000000004p-1022, -0x0.0000000000002p-1022, 0x0.0000000000002p-1022,
      0x0.0000000000004p-1022, -0x0.0000000000002p-1022, 0x0.0000000000002p-1022, 0x0.0000000000004p-1022,
      -0x0.0000000000002p-1022, -0x0.0000000000006p-1022, -0x0.0000000000002p-1022, -0x0.0000000000006p-1022,
      0x0.0000000000004p-1022}, separated, separated, separated},
    {{0, 0x1.ebb68d1db47p+54, -0x1.925d5p+64, 0, 0x1.ebb68d1db47p+54, 0x1.0520e8p+64, 0x0.0000000000001p-1022,
      0x1.15de8f840214p+55, 0, -0x0.0000000000003p-1022, -0x0.0000000000003p-1022, -0x0.0000000000003p-1022,
      0x1.ebb68d1db47p+54}, separated, separated, contact},
    {{-0x1.c69b5p+60, 0, 0x1.e801e63675p+43, 0x1.c5358p+59, -0x0.0000000000003p-1022, 0x1.e801e63675p+43, 0,
      0x0.0000000000001p-1022, 0x1.4b8e81e3c2p+44, 0, 0x0.0000000000001p-1022, -0x0.0000000000003p-1022,
      0x1.e801e63675p+43}, separated, separated, contact},
    {{-0x1.8p-19, 0x0.0000000000002p-1022, 0x1p-20, 0x1p-20, -0x1.8p-19, 0x1.8p-19, 0x1p-19, 0, 0x1p-19,
      -0x1.8p-19, 0x1.8p-19, 0x1p-20, 0x1.8p-19}, contact, contact, contact},
    {{0x1.5p+15, 0x1.8p+15, 0x1.4p+15, 0x0.0000000000001p-1022, -0x1.8p+13, -0x1.6p+15, 0x1.9p+15, -0x1.ap+15,
      -0x1.6p+14, 0x1.0cp+15, 0x1p+13, 0x1.cp+11, 0}, separated, separated, contact},
    {{-0x1.2p-2, 0x1.5p-3, 0x1.2p-3, 0x1.5p-3, 0x0.0000000000001p-1022, 0x1.bp-3, -0x1.cp-2, 0x1p-2, -0x1.6p-2,
      -0x1.acp-3, 0x1.28p-3, 0x1.3p-5, 0}, separated, separated, contact},
    {{0x1.5ef930223edcp+53, 0, -0x0.0000000000003p-1022, 0x1.e04fdd56b2718p+52, 0, -0x1.fa888p+47,
      0x1.e04fdd56b2718p+52, -0x0.0000000000003p-1022, 0x1.e073b4p+48, 0x0.0000000000001p-1022, 0, 0,
      0x1.e04fdd56b2718p+52}, contact, contact, contact},
    {{-0x1p+2, -0x1p+2, 0x1.4p+2, -0x0.0000000000003p-1022, -0x1.8p+2, -0x1p+0, 0x1.cp+2, -0x1.8p+1, -0x1.8p+2,
      0x1.4p+1, -0x1p+2, -0x1p+1, 0}, separated, separated, contact},
    {{-0x1.cp+4, 0x1.cp+4, 0x1.8p+3, 0x1.cp+4, -0x0.0000000000003p-1022, 0x1.8p+3, -0x1.cp+4, 0x1p+3, 0x1p+3,
      -0x1.cp+3, 0x1p+4, 0x1.6p+3, 0}, separated, separated, contact},
    {{0x1.358bd32efc978p-3, -0x1.655ebd0eef47p-3, 0x1.dd97bc546f38ep-1, -0x1.1d23b5cab6518p-2,
      0x1.24dbd8455fa88p-3, 0x1.db5b14000327ap-1, 0x1.4967ae4a8494cp-2, 0x1.4b7836ee2dc58p-1, -0x1.fbefe12d47afp-2,
      0x1.6f5f352319d28p-3, 0x1.607053b38d4bcp-2, -0x1.11a48ce089dbep-1, 0x1.3db9bb62f5041p-2}, separated, separated,
      separated},
    {{-0x1.d469dbe319d6cp-2, 0x1.520e3eb0efa88p-3, -0x1.b376a3405d048p-1, -0x1.3d84f1cde51ep-3,
      -0x1.f1897fca3f302p-1, -0x1.d22a0a82cf8p-2, 0x1.85801cc2204ap-3, 0x1.6c7c518a91048p-1, -0x1.e626d830fa37p-1,
      0x1.f8197e799c66cp-2, 0x1.de8d47d64263p-1, 0x1.0d7eb2c49ff86p-1, 0x1.8434434da5938p+0}, separated, separated,
      separated},
    {{-0x1.89374bc6a7efap-9, 0x1.89374bc6a7efap-9, -0x1.89374bc6a7efap-9, 0, -0x1.0624dd2f1a9fcp-10,
      -0x1.89374bc6a7efap-9, 0, -0x1.0624dd2f1a9fcp-10, -0x1.89374bc6a7efap-9, 0x1p+1, -0x1p+1, 0x1p+1,
      0x1.bb8d8f577d639p+1}, separated, separated, separated},
    {{-0x1.13b7b3b05968p-7, -0x1.f89fb756d408p-6, 0x1.0a701ffa4259p-4, 0x1.8af5348d0defap-1, 0x1.b0b5444b8d50ap-1,
      -0x1.c1c7cd53b5e98p-3, -0x1.9df1ee85e7e8p-7, -0x1.7377b48ddc20ap-1, 0x1.1093f182539e4p-2, -0x1.eed253029dfc8p-1,
      -0x1.23be3c6f71d2cp-1, -0x1.3b0271f80ce8p-6, 0x1.f71c306d3c53cp-1}, separated, separated, contact},
    {{-0x1.a703427840718p-1, -0x1.2c655eac38108p-3, 0x1.270b272d351p-8, 0x1.73858b943f31p-4, -0x1.0dad2194108cp-4,
      0x1.4f0e7a64d2a58p-2, 0x1.bbe3fe387defp-2, -0x1.c3721a10b3f74p-2, -0x1.9e9beafe19cf4p-1, 0x1.775a8996487bcp-1,
      0x1.f99b7785a817cp-2, 0x1.fa34d9aaf578p-5, 0x1.b67da86667904p-1}, separated, separated, separated},
    {{0x1.40b9c7eef9p-3, -0x1.c8e62cd5d21b8p-3, 0x1.bcc4fcd395f8p-4, 0x1.7dc37952a04bp-2, -0x1.024fc5c5868fap-1,
      0x1.4cd11d1394ad4p-1, -0x1.83089917bf88ap-1, 0x1.09a1ab525ccp-7, -0x1.5c7e0b77bd52cp-1, -0x1.e6452a4de2ce8p-1,
      -0x1.b67d927b48f34p-2, -0x1.583a7f71a1bfep-1, 0x1.e8e1e9cfbe27fp-2}, separated, separated, contact},
    {{-0x1.8p-19, -0x1.8p-19, -0x1p-19, 0x1p-19, 0x1.8p-19, -0x1p-20, 0x1p-19, 0, -0x1.8p-19, -0x1p-19, 0,
      -0x1p-19, 0x1.3625203f64e94p-20}, separated, separated, contact},
    {{-0x1.237c757b1c9c6p-1, 0x1.a59c51116040cp-1, -0x1.fcddaf939bfdp-1, -0x1.09a72f0ba8148p-1,
      -0x1.430e550c83558p-1, -0x1.d0d64400a5c3ap-1, 0x1.6f5db9661c9acp-1, -0x1.98621c5b25e9ap-1, -0x1.e0b7008ee738p-5,
      -0x1.0c4736a53bc5cp-1, -0x1.44488ed9fb23cp-2, -0x1.d9e2309d91ca6p-1, 0x1.47898ee64da3cp-9}, separated,
      separated, separated},
    {{1, 0, 0, 0, 1, 0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 1}, invalid, invalid, invalid},
    {{1, 0, 0, 0, std::numeric_limits<double>::infinity(), 0, 0, 0, 1, 0, 0, 0, 1}, invalid, invalid, invalid},
    {{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1}, invalid, invalid, invalid},
    {{0x1.8000009000000p-549, -0x1.0000006000000p-550, 0x1p500, -0x1.8p499, 0x1p498, -0x1p500, 0x1.8p499,
      -0x1p498, -0x1p500, 0, 0, 0, 0}, contact, separated, contact},
};
// clang-format on

template <class Real>
constexpr auto& stored() {
  if constexpr (sizeof(Real) == 4) return stored_floats;
  else return stored_doubles;
}

template <std::size_t most>
Verdict answered(const Answer<most>& answer, std::size_t i) noexcept {
  if (has_bit(answer.invalid[i / 64], i % 64)) return invalid;
  return has_bit(answer.contact[i / 64], i % 64) ? contact : separated;
}

template <class Real>
bool answer_as_stored(const Forms& forms, Question question, bool are_integers) noexcept {
  const auto expected = [&](const StoredAnswer<Real>& s) {
    if (question == Question::open_sphere) return s.open;
    return question == Question::conservative && !are_integers ? s.conservative : s.closed;
  };
  bool agrees = true;
  BlockAnswer answer;
  for (const StoredAnswer<Real>& s : stored<Real>()) {
    forms.pair<Real>()(s.query, s.query + 9, question, answer);
    agrees &= answered(answer, 0) == expected(s);
  }
  if (are_integers) return agrees;  // which are asked one query after the other in every shape
  // Each of them more than once, in different lanes of whole vectors and of what is left of one.
  constexpr std::size_t size = 55, count = std::size(stored<Real>());
  static_assert(size <= block_size && size > 2 * count);
  Real columns[13][size];
  Block<Real> block{{}, size, false};
  for (std::size_t k = 0; k < 13; ++k) {
    for (std::size_t i = 0; i < size; ++i) columns[k][i] = stored<Real>()[i % count].query[k];
    block.column[k] = columns[k];
  }
  forms.block<Real>()(block, question, answer);
  for (std::size_t i = 0; i < size; ++i) agrees &= answered(answer, i) == expected(stored<Real>()[i % count]);
  return agrees;
}

}  // namespace

bool answer_as_stored(const Forms& forms, bool are_integers) noexcept {
  bool agrees = true;
  for (const Question question : {Question::closed_sphere, Question::open_sphere, Question::conservative}) {
    agrees &= answer_as_stored<float>(forms, question, are_integers);
    agrees &= answer_as_stored<double>(forms, question, are_integers);
  }
  return agrees;
}

}  // namespace axiscert::certified
