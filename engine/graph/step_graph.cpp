#include "graph/step_graph.hpp"

#include <tbb/flow_graph.h>

#include <chrono>
#include <list>

namespace sandgraph::graph {

using Message = tbb::flow::continue_msg;
using Node = tbb::flow::continue_node<Message>;

struct StepGraph::Nodes {
    std::vector<Phase> phases;
    std::vector<PhaseTime> times;
    tbb::flow::graph graph;
    tbb::flow::broadcast_node<Message> start{graph};
    std::list<Node> nodes;  // stable addresses: edges point at them
};

namespace {

Node make_node(tbb::flow::graph& graph, const Phase& phase, PhaseTime& time) {
    return Node(graph, [&phase, &time](const Message&) {
        const auto begin = std::chrono::steady_clock::now();
        phase.run();
        time.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return Message();
    });
}

}  // namespace

StepGraph::StepGraph(std::vector<Phase> phases) : nodes_(std::make_unique<Nodes>()) {
    const auto before = predecessors(phases);
    nodes_->phases = std::move(phases);
    for (const Phase& phase : nodes_->phases) nodes_->times.push_back({phase.name, 0});
    std::vector<Node*> node;
    for (std::size_t k = 0; k < nodes_->phases.size(); ++k)
        node.push_back(
            &nodes_->nodes.emplace_back(make_node(nodes_->graph, nodes_->phases[k], nodes_->times[k])));
    for (std::size_t k = 0; k < node.size(); ++k) {
        if (before[k].empty()) tbb::flow::make_edge(nodes_->start, *node[k]);
        for (const std::size_t b : before[k]) tbb::flow::make_edge(*node[b], *node[k]);
    }
}

StepGraph::~StepGraph() = default;

void StepGraph::run() {
    nodes_->start.try_put(Message());
    nodes_->graph.wait_for_all();  // throws on what a phase threw
}

const std::vector<PhaseTime>& StepGraph::times() const { return nodes_->times; }

const std::vector<Phase>& StepGraph::phases() const { return nodes_->phases; }

}  // namespace sandgraph::graph
