// embed.js -- messages between an embedded page and the page around it (docs/embedding.md).

/**
 * Answers messages of the page around this one. program: its functions by name. A message is {momentscope: 'open', link},
 * {momentscope: 'get', what: 'link' | 'curves'}, and the answer {momentscope: 'link' | 'curves' | 'error', ...}.
 */
export function answerMessages({ open, link, curves }) {
    const around = window.parent;
    const tell = message => around.postMessage(message, '*');
    window.addEventListener('message', async event => {
        if (event.source !== around || typeof event.data?.momentscope !== 'string') return;
        const { momentscope: verb, link: wanted, what } = event.data;
        try {
            if (verb === 'open') await open(String(wanted));
            else if (verb === 'get' && what === 'link') tell({ momentscope: 'link', link: await link() });
            else if (verb === 'get' && what === 'curves') tell({ momentscope: 'curves', curves: JSON.parse(curves()) });
            else throw new Error(`There is no message '${verb}'${what ? ` for '${what}'` : ''}; see docs/embedding.md.`);
        } catch (error) {
            tell({ momentscope: 'error', sentence: error.message });
        }
    });
    return {
        ready: () => tell({ momentscope: 'ready' }),
        changed: fragment => tell({ momentscope: 'changed', link: fragment }),
    };
}
