#!/usr/bin/env bash
# Asks this machine's own GPU, and judges its replies: kernels of kernel/ by nvcc's program, contracted as nvcc does by default, not, and
# with --use_fast_math; then shaders on Vulkan's first adapter, in GLSL and in OpenCL C. What is not there is NOT CHECKED.
#
#   judge_device.sh AXISCERT FOLDER TRIALS
#
# FOLDER gets queries, replies and a folder of reports for each; standard output has what axiscert judge says.
set -uo pipefail
axiscert=$(realpath "$1") folder=$(mkdir -p "$2" && realpath "$2") trials=$3
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Patterns of families of the entry that is asked.
entry_families() { "$axiscert" families --predicate "$1" | cut -d' ' -f1 | grep -vE "$2" | sed 's/^/--family=/'; }
"$axiscert" generate --binary --family all --trials "$trials" -o "$folder/sphere-triangle" || exit
"$axiscert" generate --binary --family all --precision binary64 --trials $((trials / 4 + 1)) -o "$folder/sphere-triangle-64" || exit
"$axiscert" generate --binary $(entry_families moving-sphere /ends_) --trials $((trials / 8 + 1)) -o "$folder/moving-sphere" || exit
"$axiscert" generate --binary $(entry_families box-box '_(turned|minmax|mixed)$') --trials $((trials / 8 + 1)) -o "$folder/box-box" || exit

# judged NAME QUERIES OPTIONS COMMAND...: asks twice, and judges the replies.
count=0
judged() {
  local name=$1 queries=$folder/$2 options=$3 replies="$folder/$1.replies"
  echo "== $name"
  if ! "${@:4}" <"$queries" >"$replies"; then
    echo "$name: NOT CHECKED: it gave no answers"
    return
  fi
  "${@:4}" <"$queries" 2>/dev/null | cmp -s - "$replies" || echo "$name: other answers when asked again"
  "$axiscert" judge "$replies" $options --as "$name" --out "$folder/$name"
  count=$((count + 1))
}

if ! command -v nvcc >/dev/null; then
  echo "CUDA: NOT CHECKED: nvcc is not installed"
elif ! nvidia-smi >/dev/null 2>&1; then
  echo "CUDA: NOT CHECKED: no GPU of NVIDIA's answers nvidia-smi"
else
  nvidia-smi --query-gpu=name,driver_version --format=csv,noheader
  for mode in contracted: plain:-fmad=false fast:--use_fast_math; do
    flags=${mode#*:} mode=${mode%%:*} program=$folder/cuda_$mode
    nvcc -std=c++20 -O2 -arch=native --expt-relaxed-constexpr -I. $flags kernel/gpu/cuda_program.cu -o "$program" || continue
    for kernel in published reduced-nonstrict reduced-along-nonstrict closest-point; do
      for queries in sphere-triangle sphere-triangle-64; do
        judged "cuda-$mode-$kernel${queries#sphere-triangle}" $queries "--conforms-to $kernel" "$program" $kernel
      done
    done
    judged cuda-$mode-certified-filter sphere-triangle --may-decline "$program" certified-filter
    judged cuda-$mode-twenty moving-sphere "--conforms-to moving-sphere/twenty-nonstrict" "$program" moving-sphere/twenty-nonstrict
    judged cuda-$mode-segment moving-sphere "" "$program" moving-sphere/segment
    judged cuda-$mode-projected box-box "--conforms-to box-box/projected" "$program" box-box/projected
    judged cuda-$mode-textbook box-box "--conforms-to box-box/textbook" "$program" box-box/textbook
  done
fi

export AXISCERT_GPU=${AXISCERT_GPU:-hardware}
if node kernel/gpu/probe.mjs; then
  shader() { node kernel/gpu/shader.mjs "kernel/gpu/$1.wgsl" "$2"; }
  for kernel in published reduced-nonstrict reduced-nonstrict-kept closest-point; do
    judged wgsl-$kernel sphere-triangle "" shader shaders/$kernel sphere-triangle
  done
  judged wgsl-twenty moving-sphere "" shader shaders/twenty-nonstrict moving-sphere
  judged wgsl-projected box-box "" shader shaders/projected box-box/matrix
  judged wgsl-textbook box-box "" shader shaders/textbook box-box/matrix
else
  echo "shaders: NOT CHECKED"
fi
# The same in GLSL and in OpenCL C, by the first device of each; what runs on the processor is the last.
for language in glsl cl; do
  if node kernel/gpu/probe.mjs $language; then
    for kernel in published reduced-nonstrict closest-point; do
      judged $language-$kernel sphere-triangle "" node kernel/gpu/shader.mjs "kernel/gpu/shaders/$kernel.$language" sphere-triangle
    done
  else
    echo "$language: NOT CHECKED"
  fi
done
[ $count -gt 0 ] || {
  echo "NOT CHECKED: nothing here could be asked" >&2
  exit 2
}
