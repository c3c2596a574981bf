#include "exact/boxes/contact_judge.h"

namespace axiscert::boxes {

template class BoxContactJudge<float>;
template class BoxContactJudge<double>;

}  // namespace axiscert::boxes
