#include <cstdio>
#include "experiments/peers/worker.h"
#include "experiments/peers/truth.h"
using namespace kinex;
int main() {
  std::vector<PeerCase> cases = corpus_cases();
  for (int n : {8,64,255}) { cases.push_back(line_case(n,1e-3)); cases.push_back(line_case(n,-1e-3)); cases.push_back(touch_case(n)); cases.push_back(random_case(n,1)); cases.push_back(orbit_case(n,.01)); }
  for (auto& c : cases) {
    Truth t = find_truth(c);
    std::printf("%-50s %d %.9f %.9f %d\n", (c.family+" "+c.name).c_str(), (int)t.kind, t.earliest, t.latest, t.by_witness);
    std::fflush(stdout);
  }
  for (auto& m : peer_methods()) {
    auto as = ask_all(m, cases, {5, 0.001});
    std::printf("%-22s", m.name.c_str());
    for (auto& a : as) std::printf(" %d", (int)a.verdict);
    std::printf("\n");
    std::fflush(stdout);
  }
}
