#include "fuzz/confirm/class_record.h"

namespace axiscert {

Json classes_json(const ClassTally& tally, const AddressOf& address) {
  Json json = Json::object();
  for (const InputClass which : enumerators<InputClass>) {
    const ClassCount& count = tally.classes[which];
    if (count.deepest.candidates().empty()) continue;
    const Candidate<double>& deepest = count.deepest.candidates().front();
    json[std::string(input_class_names[which])] = {{"false_separation", count.false_separation},
                                                   {"false_contact", count.false_contact},
                                                   {"deepest", deepest.rank},
                                                   {"witness", address(deepest.position)}};
  }
  return json;
}

Json nearest_json(const std::optional<NearestKernel>& nearest) {
  if (!nearest) return nullptr;
  return {{"kernel", nearest->kernel->id},
          {"queries", nearest->queries},
          {"wrong", nearest->wrong},
          {"both", nearest->both},
          {"either", nearest->either}};
}

}  // namespace axiscert
