#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_WORKER_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_WORKER_H

namespace CLI {
class App;
}

namespace tetracone::experiments {

/// Adds the hidden `tetracone peer-worker NAME`, which the program starts itself: it answers for one peer what comes
/// over the socket that is its standard input, and ends when that is closed, even in the midst of an answer. Besides
/// the peers there are two for tests, which answer no to a solid question: to a surface question `crash` aborts and
/// `hang` never answers.
void add_peer_worker_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
