// Whether a guided density pays: second moment times cost, on samples that did not shape it.
//
// A sample drawn with density p that was worth Q = (f / p)^2 tells the second moment that another
// density p' would give, E_p[Q p / p'], and the cost of its paths, E_p[c p' / p]. Judged on the
// samples that had shaped the density themselves, moments come out too low.
#pragma once

namespace aips {

class SecondMoments {
  public:
    /// Least gain at which guiding is switched on, and at which it stays on. Moments are noisy,
    /// stratified plain samples do better than theirs, and learning has its price.
    static constexpr double kGain = 1.3, kStayGain = 1.15;

    /// One photon path: worth `score` and costing `cost`, drawn with density `drawn` where the
    /// plain one is `plain` and the guided one `guided` (all > 0); `guide_cost`: of guiding it.
    void add(double score, double cost, double guide_cost, double drawn, double plain,
             double guided) {
        add({score * drawn / plain, cost * plain / drawn},
            {score * drawn / guided, (cost + guide_cost) * guided / drawn});
    }
    /// What a path that was drawn adds to second moment and cost of either way of drawing it.
    struct Work {
        double score = 0, cost = 0;
    };
    void add(const Work& plain, const Work& guided) {
        plain_.add(plain.score, plain.cost);
        guided_.add(guided.score, guided.cost);
    }
    /// Keeps this share of what was counted.
    void forget(double share) {
        plain_.scale(share);
        guided_.scale(share);
    }
    /// Plain second moment times cost over the guided; 1 before anything was worth something.
    double gain() const {
        const double guided = guided_.product();
        return guided > 0 ? plain_.product() / guided : 1;
    }
    /// The switch after what it was before.
    bool pays(bool on) const { return gain() > (on ? kStayGain : kGain); }

  private:
    struct Sums {
        double moment = 0, cost = 0;
        void add(double m, double c) {
            moment += m;
            cost += c;
        }
        void scale(double share) {
            moment *= share;
            cost *= share;
        }
        double product() const { return moment * cost; }
    };
    Sums plain_, guided_;
};

}  // namespace aips
